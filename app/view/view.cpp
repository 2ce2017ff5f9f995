#include "app/view/view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <deque>

#include "app/progress.hpp"
#include "app/run.hpp"
#include "app/timed.hpp"
#include "app/view/controls.hpp"
#include "app/view/panels.hpp"
#include "app/view/picture_size.hpp"
#include "app/view/screenshot.hpp"
#include "app/view/session.hpp"
#include "gpu/presenter.hpp"
#include "render/interface.hpp"
#include "render/scene_renderer.hpp"
#include "render/window.hpp"
#include "scenarios/reader.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

using Clock = std::chrono::steady_clock;

std::string title_of(const Scenario& scenario, const std::filesystem::path& file) {
    return fmt::format("{} - waterlight", scenario.title.empty() ? file.stem().string() : scenario.title);
}

std::shared_ptr<gpu::Context> open_device(const ViewOptions& options, const Window& window) {
    return std::make_shared<gpu::Context>(gpu::ContextSettings{
        .device = options.device.device, .validation = options.device.validation, .window_system = window.system()});
}

/// Throws InputError where the window cannot show the scenario's light.
Scenario read_viewable(const ViewOptions& options) {
    Scenario scenario = read_scenario(options.scenario, options.overrides);
    if (scenario.lamp)
        scenario.origin.reject("light.type", "a lamp, by whose light the window draws no water",
                               "sun in a window; `run` with output.image = true draws what a lamp lights");
    if (!scenario.objects.empty())
        fmt::print(stderr,
                   "waterlight: the window shows what objects do to the light, not the objects; `run` with "
                   "output.image = true draws them\n");
    return scenario;
}

// Where nothing says that the session computes on Vulkan, the device and its validation are for drawing.
DeviceWish for_session(DeviceWish wish) {
    if (wish.backend != Backend::vulkan) wish.validation = false;
    if (wish.backend == Backend::cpu) wish.device.clear();
    return wish;
}

/// How many pictures a second, of those of the last second.
class Rate {
  public:
    void count() {
        const Clock::time_point now = Clock::now();
        shown_.push_back(now);
        while (now - shown_.front() > std::chrono::seconds(1)) shown_.pop_front();
    }
    double per_second() const {
        if (shown_.size() < 2) return 0;
        const std::chrono::duration<double> span = shown_.back() - shown_.front();
        return static_cast<double>(shown_.size() - 1) / span.count();
    }

  private:
    std::deque<Clock::time_point> shown_;
};

/// What the last picture of the scene was drawn of: where nothing of it has changed, it need not be drawn again.
struct Drawn {
    std::uint64_t snapshot = 0;
    Camera camera;
    Look look;
    bool operator==(const Drawn&) const = default;
};

class View {
  public:
    explicit View(const ViewOptions& options)
        : options_(options),
          scenario_(read_viewable(options)),
          window_(title_of(scenario_, options.scenario), options.size),
          context_(open_device(options, window_)),
          interface_(window_),
          presenter_(context_, window_.surface(), interface_.atlas()),
          renderer_(context_),
          session_(scenario_, for_session(options.device)),
          state_(initial_state(scenario_, options.size)),
          controls_(session_, state_),
          panels_(session_, state_, for_session(options.device), options.scenario) {
        if (options.frames) progress_.emplace(stderr, static_cast<int>(*options.frames), false, "picture");
    }

    void run() {
        const Clock::time_point start = Clock::now();
        while (!is_over()) frame();
        progress_.reset();
        if (options_.frames) say_rates(seconds_since(start));
        if (!options_.screenshot.empty() && options_.frames) {
            draw(*session_.latest(), state_.camera.size);
            write(options_.screenshot);
        }
        reject_validation_messages();
    }

  private:
    bool is_over() const {
        if (const int signal = options_.stop_signal ? options_.stop_signal() : 0)
            throw Interrupted{signal, signal == SIGINT ? "SIGINT" : "SIGTERM"};
        return window_.closing() || state_.closes || (options_.frames && shown_ >= *options_.frames);
    }

    void frame() {
        const std::vector<WindowEvent> events = wait_for_turn();
        const std::shared_ptr<const Snapshot> snapshot = session_.latest();
        const SessionStatus status = session_.status();
        for (const WindowEvent& event : events)
            controls_.handle(event, *snapshot, interface_.covers(event.at), interface_.takes_keys());
        controls_.finish();
        if (!interface_.takes_keys()) controls_.fly(window_, *snapshot, std::min(1.0 / times_.shown_hz, 0.1));
        const glm::ivec2 size = window_.size();
        if (size.x == 0 || size.y == 0) return;
        state_.camera.size = size;
        look_from_camera(status);
        interface_.begin(events);
        panels_.draw(*snapshot, status, times_);
        const gpu::InterfaceDrawing& panels = interface_.end();
        draw(*snapshot, picture_size(*snapshot, size, !status.plays));
        present(panels, size);
        if (state_.wants_screenshot) take_screenshot(*snapshot);
    }

    /// What happened until the screen shows its next picture. Of a window that shows nothing: until something happens.
    std::vector<WindowEvent> wait_for_turn() {
        const auto period = std::chrono::duration_cast<Clock::duration>(
            std::chrono::duration<double>(1 / (window_.size().x > 0 ? window_.refresh_hz() : 10)));
        turn_ = std::max(turn_ + period, Clock::now());
        std::vector<WindowEvent> events = window_.events();
        while (Clock::now() < turn_) {
            const std::vector<WindowEvent> more = window_.events(std::max(0.0, -seconds_since(turn_)));
            events.insert(events.end(), more.begin(), more.end());
        }
        return events;
    }

    /// Scattered light is drawn for where the camera is, once it was for where it has been.
    void look_from_camera(const SessionStatus& status) {
        if (seen_from_ == state_.camera || status.command < look_sent_) return;
        seen_from_ = state_.camera;
        look_sent_ = session_.look(BeamView{.camera = state_.camera});
    }

    Drawn wanted(const Snapshot& snapshot, glm::ivec2 size) const {
        Drawn wanted{snapshot.number, state_.camera, state_.look};
        wanted.camera.size = size;
        return wanted;
    }

    /// As quick as it must be; the window's own size once the water rests and nothing has moved for a while.
    glm::ivec2 picture_size(const Snapshot& snapshot, glm::ivec2 window, bool rests) const {
        constexpr double while_s = 0.3;
        const bool is_still = wanted(snapshot, drawn_.camera.size) == drawn_;
        const bool is_whole = is_still && drawn_.camera.size == window;
        const bool has_time = rests && is_still && seconds_since(drawn_at_) > while_s;
        return is_whole || (has_time && state_.reduction == 0) ? window : picture_size_.of(window, state_.reduction);
    }

    void draw(const Snapshot& snapshot, glm::ivec2 size) {
        const Drawn now = wanted(snapshot, size);
        if (now == drawn_) return;
        const Clock::time_point start = Clock::now();
        renderer_.draw(snapshot.scene(), state_.look, now.camera);
        times_.draw_ms = 1e3 * seconds_since(start);
        times_.passes = renderer_.stage_times();
        times_.picture = size;
        if (size == picture_size_.of(state_.camera.size, 0)) picture_size_.learn(times_.draw_ms);
        drawn_ = now;
        drawn_at_ = Clock::now();
        ++pictures_;
    }

    void present(const gpu::InterfaceDrawing& panels, glm::ivec2 size) {
        const Clock::time_point start = Clock::now();
        if (!presenter_.present(renderer_.picture(), panels,
                                {static_cast<std::uint32_t>(size.x), static_cast<std::uint32_t>(size.y)}))
            return;
        times_.present_ms = 1e3 * seconds_since(start);
        constexpr int settled = 20;  // pictures, after which sizes and buffers are there
        if (shown_ >= settled) slowest_ms_ = std::max(slowest_ms_, 1e3 * seconds_since(presented_at_));
        presented_at_ = Clock::now();
        rate_.count();
        times_.shown_hz = rate_.per_second();
        ++shown_;
        if (progress_) progress_->show(shown_);
    }

    void take_screenshot(const Snapshot& snapshot) {
        state_.wants_screenshot = false;
        draw(snapshot, state_.camera.size);
        const bool is_named = !options_.screenshot.empty();
        const std::filesystem::path file =
            is_named ? options_.screenshot : next_screenshot(std::filesystem::current_path());
        try {
            write(file);
        } catch (const WorldError& error) {
            state_.said = error.what();
        }
    }

    void write(const std::filesystem::path& file) {
        write_screenshot(renderer_, file);
        state_.said = fmt::format("saved {}", file.string());
    }

    void say_rates(double seconds) const {
        fmt::print(
            "{} pictures in the window in {:.2f} s, {:.1f} a second, at most {:.0f} ms apart; {} of the scene, the "
            "last "
            "{} x {} in {:.1f} ms; {:.2f} s simulated\n",
            shown_, seconds, static_cast<double>(shown_) / seconds, slowest_ms_, pictures_, times_.picture.x,
            times_.picture.y, times_.draw_ms, session_.latest()->time_s);
    }

    void reject_validation_messages() const {
        const std::vector<std::string> messages = context_->validation_messages();
        if (!messages.empty())
            throw WorldError(fmt::format("the Vulkan validation layer has {} messages; the first: {}", messages.size(),
                                         messages.front()));
    }

    ViewOptions options_;
    Scenario scenario_;
    Window window_;
    std::shared_ptr<gpu::Context> context_;
    Interface interface_;
    gpu::Presenter presenter_;
    SceneRenderer renderer_;
    Session session_;
    ViewState state_;
    Controls controls_;
    Panels panels_;

    PictureSize picture_size_;
    FrameTimes times_;
    Rate rate_;
    Drawn drawn_;
    Clock::time_point drawn_at_, presented_at_;
    double slowest_ms_ = 0;
    Camera seen_from_;
    Session::Ticket look_sent_ = 0;
    Clock::time_point turn_;
    int shown_ = 0, pictures_ = 0;
    std::optional<Progress> progress_;
};

}  // namespace

void view_scenario(const ViewOptions& options) { View(options).run(); }

}  // namespace waterlight
