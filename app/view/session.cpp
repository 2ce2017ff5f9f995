#include "app/view/session.hpp"

#include <fmt/format.h>

#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <string_view>
#include <thread>

#include "app/view/pace.hpp"
#include "app/view/simulation.hpp"
#include "app/view/snapshot_pool.hpp"
#include "sim/error.hpp"
#include "sim/message.hpp"

namespace waterlight {

namespace {

using Clock = std::chrono::steady_clock;

/// What stands between a failure and the next run.
constexpr std::string_view ended = "the run has ended; a reset or other settings begin another";

}  // namespace

struct Session::Impl {
    Impl(const Scenario& scenario, const DeviceWish& device, const SessionSettings& s)
        : settings(s), pace(s.frame_s), plays(s.plays) {
        if (!(s.frame_s > 0) || s.estimate_every < 1)
            throw InputError("session: frame_s must be above 0 and estimate_every at least 1");
        thread = std::thread([this, scenario, device] { live(scenario, device); });
        std::unique_lock lock(mutex);
        done.wait(lock, [&] { return latest || broken; });
        if (!broken) return;
        lock.unlock();
        thread.join();
        std::rethrow_exception(broken);
    }

    ~Impl() {
        {
            const std::scoped_lock lock(mutex);
            stops = true;
        }
        work.notify_all();
        if (thread.joinable()) thread.join();
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    /// What a command is to those that wait beside it.
    enum class Kind {
        other,
        last_counts,  ///< the later of two of one name in a row makes the earlier needless
        builds        ///< takes long, and can begin a run anew
    };
    struct Command {
        std::string_view name;
        Kind kind = Kind::other;
        std::function<void(Impl&)> act;
        Ticket ticket = 0;
    };

    Ticket send(std::string_view name, Kind kind, std::function<void(Impl&)> act) {
        Ticket ticket = 0;
        {
            const std::scoped_lock lock(mutex);
            ticket = ++tickets;
            Command command{name, kind, std::move(act), ticket};
            const bool replaces = kind == Kind::last_counts && !queue.empty() && queue.back().name == name;
            if (replaces)
                queue.back() = std::move(command);
            else
                queue.push_back(std::move(command));
        }
        work.notify_all();
        return ticket;
    }

    // The rest is the worker's.

    void live(const Scenario& scenario, const DeviceWish& device) {
        try {
            simulation.emplace(scenario, device);
            std::shared_ptr<Snapshot> first = picture(true);
            settle();
            publish(std::move(first));
        } catch (...) {
            simulation.reset();
            const std::scoped_lock lock(mutex);
            broken = std::current_exception();
            done.notify_all();
            return;
        }
        pace.begin(Clock::now());
        while (wait_for_work()) {
            obey();
            if (plays) frame();
        }
        simulation.reset();
    }

    /// Whether there is any, and not the end.
    bool wait_for_work() {
        std::unique_lock lock(mutex);
        work.wait(lock, [&] { return stops || plays || !queue.empty(); });
        return !stops;
    }

    void obey() {
        while (const std::optional<Command> command = next_command()) {
            obey(*command);
            obeyed = command->ticket;
            if (takes_step) step();
        }
        if (is_changed && !plays) guarded([&] { publish(picture(true)); });
        is_changed = false;
        settle();
    }

    void step() {
        takes_step = is_changed = false;
        guarded([&] {
            simulation->advance(settings.frame_s * pace.speed());
            publish(picture(true));
        });
    }

    std::optional<Command> next_command() {
        const std::scoped_lock lock(mutex);
        if (queue.empty() || stops) return std::nullopt;
        Command command = std::move(queue.front());
        queue.pop_front();
        status.is_building = command.kind == Kind::builds;
        return command;
    }

    void obey(const Command& command) {
        const bool builds = command.kind == Kind::builds;
        if (!failure.empty() && !builds) return refuse(command.ticket, std::string(ended));
        try {
            command.act(*this);
            is_changed = true;
            if (builds) failure.clear();
        } catch (const InputError& error) {
            refuse(command.ticket, error.what());
        } catch (const std::exception& error) {
            if (builds)
                refuse(command.ticket, error.what());
            else
                fail(error.what());
        }
    }

    void refuse(Ticket ticket, std::string_view why) {
        const std::scoped_lock lock(mutex);
        status.refusal = in_one_line(why);
        status.refused = ticket;
    }

    void fail(std::string_view why) {
        failure = in_one_line(why);
        plays = false;
        simulation->give_up();
    }

    template <class Work>
    void guarded(Work work_to_do) {
        if (!failure.empty()) return;
        try {
            work_to_do();
        } catch (const std::exception& error) {
            fail(error.what());
        }
    }

    void frame() {
        guarded([&] {
            simulation->advance(settings.frame_s * pace.speed());
            std::shared_ptr<Snapshot> next = picture(++since_estimate >= settings.estimate_every);
            wait_until(pace.due());
            pace.shown(Clock::now(), next->time_s);
            publish(std::move(next));
        });
        settle();
    }

    /// Or until the end.
    void wait_until(Clock::time_point due) {
        std::unique_lock lock(mutex);
        work.wait_until(lock, due, [&] { return stops; });
    }

    std::shared_ptr<Snapshot> picture(bool estimates) {
        std::shared_ptr<Snapshot> next = pool.take();
        simulation->show(*next, estimates);
        if (estimates) since_estimate = 0;
        next->number = ++pictures;
        next->command = obeyed;
        return next;
    }

    void publish(std::shared_ptr<const Snapshot> next) {
        {
            const std::scoped_lock lock(mutex);
            std::swap(latest, next);
        }
        done.notify_all();
    }

    /// Says how things stand.
    void settle() {
        const bool is_new = !edits_now || obeyed != settled;
        std::shared_ptr<const Edits> edits = is_new ? std::make_shared<const Edits>(simulation->edits()) : edits_now;
        settled = obeyed;
        {
            const std::scoped_lock lock(mutex);
            status.plays = plays;
            status.is_building = false;
            status.speed = pace.speed();
            status.rate = plays ? pace.rate() : 0;
            status.command = obeyed;
            status.note = simulation->note();
            status.failure = failure;
            std::swap(edits_now, edits);
            scenario_now = simulation->scenario();
        }
        done.notify_all();
    }

    const SessionSettings settings;
    SnapshotPool pool;
    std::optional<Simulation> simulation;
    Pace pace;
    bool plays;
    bool is_changed = false, takes_step = false;
    int since_estimate = 0;
    std::uint64_t pictures = 0;
    Ticket obeyed = 0, settled = 0;
    std::string failure;

    // Shared, under the mutex.
    mutable std::mutex mutex;
    mutable std::condition_variable work, done;
    std::deque<Command> queue;
    Ticket tickets = 0;
    bool stops = false;
    SessionStatus status;
    std::shared_ptr<const Snapshot> latest;
    std::shared_ptr<const Edits> edits_now;
    std::shared_ptr<const Scenario> scenario_now;
    std::exception_ptr broken;

    std::thread thread;
};

Session::Session(const Scenario& scenario, const DeviceWish& device, const SessionSettings& settings)
    : impl_(std::make_unique<Impl>(scenario, device, settings)) {}

Session::~Session() = default;

std::shared_ptr<const Snapshot> Session::latest() const {
    const std::scoped_lock lock(impl_->mutex);
    return impl_->latest;
}

SessionStatus Session::status() const {
    const std::scoped_lock lock(impl_->mutex);
    return impl_->status;
}

void Session::await(Ticket command) const {
    std::unique_lock lock(impl_->mutex);
    impl_->done.wait(lock, [&] { return impl_->status.command >= command; });
}

Session::Ticket Session::play() {
    return impl_->send("play", Impl::Kind::other, [](Impl& s) {
        s.plays = true;
        s.pace.begin(Clock::now());
    });
}

Session::Ticket Session::pause() {
    return impl_->send("pause", Impl::Kind::other, [](Impl& s) { s.plays = false; });
}

Session::Ticket Session::step() {
    return impl_->send("step", Impl::Kind::other, [](Impl& s) {
        s.plays = false;
        s.takes_step = true;
    });
}

Session::Ticket Session::reset() {
    return impl_->send("reset", Impl::Kind::builds, [](Impl& s) { s.simulation->reset(); });
}

Session::Ticket Session::speed(double simulated_per_wall) {
    return impl_->send("speed", Impl::Kind::last_counts, [simulated_per_wall](Impl& s) {
        if (!(simulated_per_wall >= 0.001 && simulated_per_wall <= 100))
            throw InputError(fmt::format("speed: found {}; allowed: in [0.001, 100]", simulated_per_wall));
        s.pace.set_speed(simulated_per_wall);
    });
}

Session::Ticket Session::drop(glm::dvec2 at_m, double radius_m, double height_m) {
    return impl_->send("drop", Impl::Kind::other, [=](Impl& s) { s.simulation->drop(at_m, radius_m, height_m); });
}

Session::Ticket Session::hold_sphere(const HeldSphere& sphere) {
    return impl_->send("hold", Impl::Kind::other, [=](Impl& s) { s.simulation->hold_sphere(sphere); });
}

Session::Ticket Session::move_sphere(glm::dvec3 centre_m) {
    // Two moves push as the one from the first place to the last does.
    return impl_->send("move", Impl::Kind::last_counts, [=](Impl& s) { s.simulation->move_sphere(centre_m); });
}

Session::Ticket Session::release_sphere() {
    return impl_->send("release", Impl::Kind::other, [](Impl& s) { s.simulation->release_sphere(); });
}

Session::Ticket Session::rain(std::optional<double> drops_per_m2_s) {
    return impl_->send("rain", Impl::Kind::last_counts, [=](Impl& s) { s.simulation->rain(drops_per_m2_s); });
}

Session::Ticket Session::sun(double elevation_deg, double azimuth_deg) {
    return impl_->send("sun", Impl::Kind::last_counts, [=](Impl& s) { s.simulation->sun(elevation_deg, azimuth_deg); });
}

Session::Ticket Session::look(const std::optional<BeamView>& view) {
    return impl_->send("look", Impl::Kind::last_counts, [=](Impl& s) { s.simulation->look(view); });
}

Session::Ticket Session::compute(LightPart part, bool on) {
    return impl_->send("compute", Impl::Kind::builds, [=](Impl& s) { s.simulation->compute(part, on); });
}

Session::Ticket Session::set(std::vector<std::string> overrides) {
    return impl_->send("set", Impl::Kind::builds,
                       [overrides = std::move(overrides)](Impl& s) { s.simulation->set(overrides); });
}

Session::Ticket Session::set_device(const DeviceWish& device) {
    return impl_->send("device", Impl::Kind::builds, [=](Impl& s) { s.simulation->set_device(device); });
}

std::string Session::text() const {
    std::unique_lock lock(impl_->mutex);
    const std::shared_ptr<const Edits> edits = impl_->edits_now;
    const std::shared_ptr<const Scenario> scenario = impl_->scenario_now;
    lock.unlock();
    return edits->text(*scenario);
}

void Session::save(const std::filesystem::path& file) const {
    std::unique_lock lock(impl_->mutex);
    const std::shared_ptr<const Edits> edits = impl_->edits_now;
    const std::shared_ptr<const Scenario> scenario = impl_->scenario_now;
    lock.unlock();
    edits->save(*scenario, file);
}

}  // namespace waterlight
