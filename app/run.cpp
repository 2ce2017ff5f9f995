#include "app/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>

#include "app/check_watch.hpp"
#include "app/checkpoint.hpp"
#include "app/frame_stages.hpp"
#include "app/moments.hpp"
#include "app/movie.hpp"
#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "app/recorder.hpp"
#include "app/run_folder.hpp"
#include "app/shallow_watch.hpp"
#include "app/summary.hpp"
#include "app/timed.hpp"
#include "export/checkpoint_file.hpp"
#include "export/report.hpp"
#include "gpu/error.hpp"
#include "scenarios/reader.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// The stages of a run, and who keeps what they compute.
class Run {
  public:
    Run(const RunOptions& options, fs::path out, const Scenario& scenario)
        : options_(options),
          out_(std::move(out)),
          scenario_(scenario),
          recorder_(scenario),
          stages_(scenario, options.device),
          checks_(scenario),
          moments_(moments_of(scenario)) {
        if (const PictureStage* picture = stages_.picture()) recorder_.record().picture_device = picture->device();
    }

    bool go() {
        const bool goes_on = options_.resume && fs::exists(checkpoint());
        // The first frame is computed before a file is written: what is wrong with the scenario shows by then.
        if (goes_on) {
            stages_.look(wall());
        } else {
            scenario_.origin.in_place("caustics", [this] { stages_.compute(wall()); });
            checks_.require_references(stages_.fields());
        }
        const RunFolder folder(out_);
        if (const auto* model = stages_.waves().shallow) shallow_.emplace(scenario_, *model, stages_.surface());
        std::optional<StateArchive> state;
        if (goes_on) state = restored();
        if (!options_.quiet) say_where_it_starts(goes_on);
        if (!goes_on) fs::remove(checkpoint());
        Outputs outputs(folder, scenario_, state ? &*state : nullptr);
        if (state) state->require_end();
        state.reset();
        fs::remove(out_ / "report.json");
        write_all(outputs);
        if (options_.movie)
            timed(wall().movie, [&] { write_movie(movie_file(), movie_pictures(outputs), movie_rate()); });
        reject_validation_messages();
        const bool all_pass = report(outputs);
        fs::remove(checkpoint());
        return all_pass;
    }

  private:
    StageTimes& wall() { return recorder_.record().wall; }

    fs::path checkpoint() const { return out_ / Outputs::checkpoint_name; }

    /// What the run is at between two moments.
    void exchange_state(StateArchive& state) {
        exchange_identity(state, identity_of(scenario_, stages_.backend(), recorder_.record().picture_device),
                          checkpoint());
        state.value(next_);
        stages_.exchange_water(state);
        recorder_.exchange_state(state);
        stages_.exchange_light(state);
        checks_.exchange_state(state);
        if (shallow_) shallow_->exchange_state(state);
        stages_.exchange_accuracy(state);
    }

    /// Takes the state of the checkpoint; what is left of it is that of the outputs.
    StateArchive restored() {
        StateArchive state(read_checkpoint(checkpoint()));
        exchange_state(state);
        earlier_ = wall();
        return state;
    }

    void say_where_it_starts(bool goes_on) const {
        if (goes_on)
            fmt::print(stderr, "going on from {} at t = {:.6g} s\n", checkpoint().string(), moments_[next_ - 1].time_s);
        else if (options_.resume)
            fmt::print(stderr, "no checkpoint in {}: starting from the beginning\n", out_.string());
        else if (fs::exists(checkpoint()))
            fmt::print(stderr, "starting from the beginning; {} is of a run that --resume would have gone on with\n",
                       checkpoint().string());
    }

    /// All moments that are left. A failure names the checkpoint to go on from.
    void write_all(Outputs& outputs) {
        try {
            visit_all(outputs);
            end(moments_.back().time_s, outputs);
            outputs.finish();
            update_wall(outputs);
        } catch (const WorldError& error) {
            throw WorldError(error.what() + last_checkpoint(outputs));
        } catch (const gpu::Error& error) {
            throw gpu::Error(error.what() + last_checkpoint(outputs));
        }
    }

    std::string last_checkpoint(Outputs& outputs) const {
        const std::optional<double> time_s = outputs.last_checkpoint_s();
        if (!time_s) return "; there is no checkpoint";
        return fmt::format("; the last good checkpoint is {} of t = {:.6g} s", checkpoint().string(), *time_s);
    }

    void visit_all(Outputs& outputs) {
        const auto is_frame = [](const Moment& moment) { return moment.is_frame; };
        const int frames = static_cast<int>(std::count_if(moments_.begin(), moments_.end(), is_frame));
        Progress progress(stderr, frames, options_.quiet);
        watch_every_ = (frames + watched_frames - 1) / watched_frames;
        while (next_ < moments_.size()) {
            const Moment& moment = moments_[next_];
            visit(moment, outputs);
            ++next_;
            if (moment.is_frame) progress.show(recorder_.record().frames);
            if (next_ == moments_.size()) return;
            const int signal = moment.is_frame && options_.stop_signal ? options_.stop_signal() : 0;
            if (signal != 0 || is_checkpoint_due()) save(moment.time_s, outputs);
            if (signal != 0) stop(moment.time_s, signal, outputs);
        }
    }

    void visit(const Moment& moment, Outputs& outputs) {
        // What is refused once files are written is a failure of the run.
        try {
            if (next_ > 0) stages_.advance(moment.time_s - moments_[next_ - 1].time_s, wall());
            if (!moment.is_frame) return record_row(moment.time_s, outputs);
            if (next_ > 0) stages_.compute(wall());
        } catch (const InputError& error) {
            throw WorldError(fmt::format("at t = {:.6g} s: {}", moment.time_s, error.what()));
        }
        record(moment.time_s, next_ + 1 == moments_.size(), outputs);
    }

    bool is_checkpoint_due() const {
        const double every_s = scenario_.output.checkpoint_every_s;
        return every_s > 0 && std::chrono::duration<double>(Clock::now() - saved_).count() >= every_s;
    }

    void save(double time_s, Outputs& outputs) {
        update_wall(outputs);
        StateArchive state;
        timed(wall().diagnostics, [&] { exchange_state(state); });
        outputs.push_checkpoint(time_s, std::move(state));
        saved_ = Clock::now();
    }

    /// Reports what there is, and ends. The checkpoint is on its way: what is added for the report is not part of it.
    [[noreturn]] void stop(double time_s, int signal, Outputs& outputs) {
        recorder_.add_waves(time_s, stages_.waves().model->diagnostics());
        if (stages_.floor()) recorder_.add_statistics(stages_.map());
        if (shallow_) shallow_->finish(stages_.surface(), recorder_.record());
        outputs.settle();
        update_wall(outputs);
        nlohmann::ordered_json json = report_json(scenario_, stages_.backend(), completed(), {});
        const char* name = signal_name(signal);
        json["interrupted"] = {{"signal", name}, {"time_s", time_s}};
        write_json(out_ / "report.json", json);
        throw Interrupted{signal, fmt::format("{} at t = {:.6g} s; run --resume goes on from {}", name, time_s,
                                              checkpoint().string())};
    }

    void update_wall(const Outputs& outputs) {
        wall().export_busy = earlier_.export_busy + outputs.busy_s();
        wall().export_blocked = earlier_.export_blocked + outputs.blocked_s();
        wall().total = earlier_.total + std::chrono::duration<double>(Clock::now() - start_).count();
    }

    std::vector<double> read_probes() {
        return recorder_.add_probes(stages_.surface(), [this](const Probe& probe) { return stages_.light_at(probe); });
    }

    void record(double time_s, bool last, Outputs& outputs) {
        std::vector<double> probes;
        timed(wall().diagnostics, [&] {
            const bool is_checked = checks_.wants(time_s);
            const bool watched = last || is_checked || recorder_.record().frames % watch_every_ == 0;
            if (watched) recorder_.add_waves(time_s, stages_.waves().model->diagnostics());
            if (shallow_) shallow_->add_frame(stages_.surface());
            if (shallow_ && watched) shallow_->add_totals();
            recorder_.add_frame(time_s);
            if (const FloorStage* floor = stages_.floor()) {
                recorder_.add_floor(stages_.map(), floor->ledger(stages_.map()), floor->record(stages_.map()));
                if (last || is_checked) recorder_.add_statistics(stages_.map());
            }
            stages_.add_frame(time_s);
            probes = read_probes();
            checks_.add_row(time_s, recorder_.record().probes);
            if (is_checked) add_checked(time_s);
        });
        FrameView frame = stages_.view();
        if (const PictureStage* picture = stages_.picture()) frame.scene = &picture->picture();
        frame.ledgers = ledgers();
        outputs.push(frame, std::move(probes));
    }

    /// A frame that checks judge: by the record as it would be if the run ended here.
    void add_checked(double time_s) {
        if (shallow_) shallow_->finish(stages_.surface(), recorder_.record());
        try {
            checks_.add_frame(time_s, quantities_of(completed()), stages_.fields());
        } catch (const InputError& error) {
            throw WorldError(error.what());
        }
    }

    const RunRecord& completed() {
        RunRecord& record = recorder_.record();
        stages_.complete(record);
        return record;
    }

    /// Of the frame just recorded, in the order of the columns of ledger.csv.
    std::vector<LightLedger> ledgers() {
        std::vector<LightLedger> all;
        if (stages_.floor()) all.push_back(recorder_.record().floor->last_ledger);
        if (const BeamStage* beams = stages_.beams()) all.push_back(beams->ledger());
        if (const WallStage* walls = stages_.walls()) all.push_back(walls->maps().ledger);
        return all;
    }

    void record_row(double time_s, Outputs& outputs) {
        stages_.compute_for_probes(wall());
        std::vector<double> probes;
        timed(wall().diagnostics, [&] { probes = read_probes(); });
        checks_.add_row(time_s, recorder_.record().probes);
        outputs.push_row(time_s, std::move(probes));
    }

    fs::path movie_file() const { return options_.movie->empty() ? out_ / "movie.mp4" : *options_.movie; }

    double movie_rate() const { return options_.movie_speed / scenario_.output.every_s; }

    std::vector<fs::path> movie_pictures(const Outputs& outputs) const {
        std::vector<fs::path> pictures;
        for (const int frame : regular_frames(moments_, scenario_.output.every_s))
            pictures.push_back(outputs.scene_file(frame));
        return pictures;
    }

    void end(double time_s, Outputs& outputs) {
        if (!shallow_) return;
        timed(wall().diagnostics, [&] { shallow_->finish(stages_.surface(), recorder_.record()); });
        outputs.push_end(stages_.surface().grid, time_s, shallow_->bed_m(), shallow_->records(), shallow_->lines());
    }

    void reject_validation_messages() const {
        const std::vector<std::string> messages = stages_.validation_messages();
        if (!messages.empty())
            throw WorldError(fmt::format("the Vulkan validation layer has {} messages; the first: {}", messages.size(),
                                         messages.front()));
    }

    bool report(const Outputs& outputs) {
        const RunRecord& record = completed();
        const std::vector<CheckResult> checks = judge(scenario_.checks, checks_.values());
        write_json(out_ / "report.json", report_json(scenario_, stages_.backend(), record, checks));
        std::vector<std::string> guide = outputs.guide();
        if (options_.movie) guide.push_back(guide_line(movie_file(), "the scene in time: any video player"));
        bool all_pass = true;
        for (const CheckResult& check : checks) all_pass = all_pass && (check.pass || check.is_left);
        if (options_.quiet)
            print_failures(checks);
        else
            print_summary(scenario_, stages_.backend(), record, checks, guide);
        return all_pass;
    }

    /// Diagnostics of a model may cost as much as many steps: so many frames of a run are watched, and the last.
    static constexpr int watched_frames = 32;

    const RunOptions& options_;
    fs::path out_;
    const Scenario& scenario_;
    Recorder recorder_;
    FrameStages stages_;
    CheckWatch checks_;
    std::optional<ShallowWatch> shallow_;
    int watch_every_ = 1;
    std::vector<Moment> moments_;
    std::size_t next_ = 0;  ///< of the moments
    Clock::time_point start_ = Clock::now(), saved_ = start_;
    StageTimes earlier_;  ///< of the parts of the run before this one
};

}  // namespace

bool run_scenario(const RunOptions& options) {
    const Scenario scenario = read_scenario(options.scenario, options.overrides);
    if (options.movie && !scenario.output.image)
        scenario.origin.reject("output.image", "false beside --movie", "true, with a [camera]");
    if (options.movie) require_ffmpeg();
    if (scenario.decided && !scenario.decided->warning.empty())
        fmt::print(stderr, "waterlight: {}\n", scenario.decided->warning);
    const fs::path out = options.out.empty() ? fs::path("out") / options.scenario.stem() : options.out;
    return Run(options, out, scenario).go();
}

}  // namespace waterlight
