#include "app/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/beam_stage.hpp"
#include "app/check_watch.hpp"
#include "app/checkpoint.hpp"
#include "app/moments.hpp"
#include "app/movie.hpp"
#include "app/outputs.hpp"
#include "app/picture_stage.hpp"
#include "app/progress.hpp"
#include "app/readings.hpp"
#include "app/recorder.hpp"
#include "app/run_folder.hpp"
#include "app/shallow_watch.hpp"
#include "app/summary.hpp"
#include "app/timed.hpp"
#include "app/wall_stage.hpp"
#include "export/checkpoint_file.hpp"
#include "export/report.hpp"
#include "gpu/error.hpp"
#include "scenarios/build.hpp"
#include "scenarios/reader.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// What a part of the program refuses, with the place of the section that asked for it.
template <class Work>
auto for_section(const Scenario& s, std::string_view section, Work work) {
    try {
        return work();
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}: {}", s.origin.place(section), section, error.what()));
    }
}

/// The parts of a run, in the order of the data flow.
class Run {
  public:
    Run(const RunOptions& options, fs::path out, const Scenario& scenario)
        : options_(options),
          out_(std::move(out)),
          scenario_(scenario),
          backend_(choose_backend(options.device, scenario)),
          waves_(for_section(scenario, "waves", [&] { return build_model(scenario, backend_.context); })),
          floor_(scenario.floor ? for_section(scenario, "caustics.floor",
                                              [&] { return make_floor_stage(scenario, waves_, backend_); })
                                : nullptr),
          recorder_(scenario),
          checks_(scenario),
          moments_(moments_of(scenario)) {
        if (scenario.beams)
            for_section(scenario, "caustics.beams",
                        [&] { beams_.emplace(scenario, waves_, make_beam_renderer(backend_)); });
        if (scenario.walls) walls_.emplace(scenario);
        if (scenario.accuracy.estimate) accuracy_.emplace(scenario, waves_, backend_);
        if (scenario.output.image) picture_.emplace(scenario, waves_, backend_, options.device);
        if (picture_) recorder_.record().picture_device = picture_->device();
    }

    bool go() {
        const bool goes_on = options_.resume && fs::exists(checkpoint());
        // The first frame is computed before a file is written: what is wrong with the scenario shows by then.
        if (goes_on) {
            look();
        } else {
            for_section(scenario_, "caustics", [this] { compute(); });
            checks_.require_references(fields());
        }
        const RunFolder folder(out_);
        if (waves_.shallow) shallow_.emplace(scenario_, *waves_.shallow, *surface_);
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
        exchange_identity(state, identity_of(scenario_, backend_, recorder_.record().picture_device), checkpoint());
        state.value(next_);
        waves_.model->exchange_state(state);
        recorder_.exchange_state(state);
        if (beams_) beams_->exchange_state(state);
        if (walls_) walls_->exchange_state(state);
        checks_.exchange_state(state);
        if (shallow_) shallow_->exchange_state(state);
        if (accuracy_) accuracy_->exchange_state(state);
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
            if (next_ > 0) advance(moment.time_s - moments_[next_ - 1].time_s);
            if (!moment.is_frame) return record_row(moment.time_s, outputs);
            if (next_ > 0) compute();
        } catch (const InputError& error) {
            throw WorldError(fmt::format("at t = {:.6g} s: {}", moment.time_s, error.what()));
        }
        record(moment.time_s, next_ + 1 == moments_.size(), outputs);
    }

    void advance(double seconds) {
        timed(wall().waves, [&] { waves_.model->advance(seconds); });
        if (accuracy_) timed(wall().accuracy, [&] { accuracy_->advance(seconds); });
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
        recorder_.add_waves(time_s, waves_.model->diagnostics());
        if (floor_) recorder_.add_statistics(map_);
        if (shallow_) shallow_->finish(*surface_, recorder_.record());
        outputs.settle();
        update_wall(outputs);
        nlohmann::ordered_json json = report_json(scenario_, backend_, completed(), {});
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

    void look() {
        timed(wall().waves, [&] { surface_ = &waves_.model->surface(); });
        timed(wall().diagnostics, [&] { require_finite(*surface_, waves_.model->steps()); });
    }

    void compute() {
        look();
        const Instant now{surface_->time_s, waves_.model->steps()};
        if (floor_) {
            timed(wall().floor, [&] { floor_->compute(*surface_, map_); });
            timed(wall().diagnostics, [&] {
                require_finite("irradiance on the floor", map_.irradiance, now);
                require_finite("the floor map", floor_->ledger(map_), now);
            });
        }
        if (beams_) {
            timed(wall().beams, [&] { beams_->compute(*surface_); });
            timed(wall().diagnostics, [&] { require_finite_light(now); });
        }
        if (walls_) {
            timed(wall().walls, [&] { walls_->compute(*surface_); });
            for (const Field<float>& map : walls_->maps().irradiance) require_finite("irradiance on a wall", map, now);
            require_finite("the walls", walls_->maps().ledger, now);
        }
        if (accuracy_) {
            timed(wall().accuracy, [&] { accuracy_->compute(*surface_, floor_ ? &map_ : nullptr); });
            timed(wall().diagnostics, [&] { require_finite_errors(now); });
        }
        if (picture_) timed(wall().render, [&] { picture_->draw(view()); });
    }

    /// What probes read between frames. The truth of a place needs no map.
    void compute_for_probes() {
        look();
        bool in_water = false, on_floor = false;
        for (const Probe& probe : scenario_.probes) (probe.depth_m ? in_water : on_floor) = true;
        if (on_floor && floor_ && scenario_.floor->method != FloorMethod::truth)
            timed(wall().floor, [&] { floor_->compute(*surface_, map_); });
        if (in_water) timed(wall().beams, [&] { beams_->compute_beams(*surface_); });
    }

    void require_finite_light(const Instant& now) const {
        if (const BeamVolume* volume = beams_->volume()) {
            require_finite("downward irradiance in the water", volume->plane_irradiance, now);
            require_finite("scalar irradiance in the water", volume->scalar_irradiance, now);
        }
        if (const BeamImage* picture = beams_->image()) require_finite("scattered light", picture->radiance, now);
    }

    void require_finite_errors(const Instant& now) const {
        if (const Field<float>* error = accuracy_->floor_error())
            require_finite("estimated error of the irradiance on the floor", *error, now);
        if (const Field<float>* error = accuracy_->waves_error())
            require_finite("estimated error of the elevation", *error, now);
    }

    /// As a probe reads it: in the water, or on the floor.
    ProbeLight light_at(const Probe& probe) const {
        ProbeLight light;
        if (probe.depth_m) {
            const PointIrradiance found = beams_->irradiance_at(probe.at_m, *probe.depth_m);
            light = {found.plane_w_m2, found.scalar_w_m2};
        } else if (floor_) {
            light.plane_w_m2 = floor_->irradiance_at(*surface_, map_, probe.at_m);
        }
        return light;
    }

    std::vector<double> read_probes() {
        return recorder_.add_probes(*surface_, [this](const Probe& probe) { return light_at(probe); });
    }

    void record(double time_s, bool last, Outputs& outputs) {
        std::vector<double> probes;
        timed(wall().diagnostics, [&] {
            const bool is_checked = checks_.wants(time_s);
            const bool watched = last || is_checked || recorder_.record().frames % watch_every_ == 0;
            if (watched) recorder_.add_waves(time_s, waves_.model->diagnostics());
            if (shallow_) shallow_->add_frame(*surface_);
            if (shallow_ && watched) shallow_->add_totals();
            recorder_.add_frame(time_s);
            if (floor_) {
                recorder_.add_floor(map_, floor_->ledger(map_), floor_->record(map_));
                if (last || is_checked) recorder_.add_statistics(map_);
            }
            if (beams_) {
                beams_->add_frame(time_s);
                require_finite("the beams", beams_->ledger(), {time_s, waves_.model->steps()});
            }
            if (walls_) walls_->add_frame();
            probes = read_probes();
            checks_.add_row(time_s, recorder_.record().probes);
            if (is_checked) add_checked(time_s);
        });
        FrameView frame = view();
        if (picture_) frame.scene = &picture_->picture();
        frame.ledgers = ledgers();
        outputs.push(frame, std::move(probes));
    }

    /// What was computed of this frame.
    FrameView view() const {
        const FrameFields now = fields();
        FrameView frame{now.surface, now.floor, now.volume, now.picture};
        if (accuracy_) frame.floor_error = accuracy_->floor_error();
        if (accuracy_) frame.waves_error = accuracy_->waves_error();
        if (walls_) frame.walls = &walls_->maps();
        if (floor_) frame.bands = floor_->bands();
        return frame;
    }

    FrameFields fields() const {
        return {*surface_, floor_ ? &map_ : nullptr, beams_ ? beams_->volume() : nullptr,
                beams_ ? beams_->image() : nullptr};
    }

    /// A frame that checks judge: by the record as it would be if the run ended here.
    void add_checked(double time_s) {
        if (shallow_) shallow_->finish(*surface_, recorder_.record());
        try {
            checks_.add_frame(time_s, quantities_of(completed()), fields());
        } catch (const InputError& error) {
            throw WorldError(error.what());
        }
    }

    const RunRecord& completed() {
        RunRecord& record = recorder_.record();
        record.waves.model = waves_.model->name();
        record.waves.steps = waves_.model->steps();
        if (beams_) record.beams = beams_->record();
        if (walls_) record.walls = walls_->record();
        if (accuracy_) {
            record.accuracy = accuracy_->record();
            if (record.floor && record.floor->method.method == FloorMethod::truth)
                record.accuracy->floor_rmse = record.floor->method.error_estimate;
        }
        if (waves_.airy && !waves_.sea.empty()) record.sea = SeaRecord{waves_.airy->sea_coverage(), waves_.sea};
        return record;
    }

    /// Of the frame just recorded, in the order of the columns of ledger.csv.
    std::vector<LightLedger> ledgers() {
        std::vector<LightLedger> all;
        if (floor_) all.push_back(recorder_.record().floor->last_ledger);
        if (beams_) all.push_back(beams_->ledger());
        if (walls_) all.push_back(walls_->maps().ledger);
        return all;
    }

    void record_row(double time_s, Outputs& outputs) {
        compute_for_probes();
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
        timed(wall().diagnostics, [&] { shallow_->finish(*surface_, recorder_.record()); });
        outputs.push_end(surface_->grid, time_s, shallow_->bed_m(), shallow_->records(), shallow_->lines());
    }

    void reject_validation_messages() const {
        std::vector<std::string> messages;
        if (backend_.context) messages = backend_.context->validation_messages();
        if (messages.empty() && picture_) messages = picture_->validation_messages();
        if (!messages.empty())
            throw WorldError(fmt::format("the Vulkan validation layer has {} messages; the first: {}", messages.size(),
                                         messages.front()));
    }

    bool report(const Outputs& outputs) {
        const RunRecord& record = completed();
        const std::vector<CheckResult> checks = judge(scenario_.checks, checks_.values());
        write_json(out_ / "report.json", report_json(scenario_, backend_, record, checks));
        std::vector<std::string> guide = outputs.guide();
        if (options_.movie) guide.push_back(guide_line(movie_file(), "the scene in time: any video player"));
        bool all_pass = true;
        for (const CheckResult& check : checks) all_pass = all_pass && (check.pass || check.is_left);
        if (options_.quiet)
            print_failures(checks);
        else
            print_summary(scenario_, backend_, record, checks, guide);
        return all_pass;
    }

    /// Diagnostics of a model may cost as much as many steps: so many frames of a run are watched, and the last.
    static constexpr int watched_frames = 32;

    const RunOptions& options_;
    fs::path out_;
    const Scenario& scenario_;
    BackendDecision backend_;
    BuiltModel waves_;
    std::unique_ptr<FloorStage> floor_;
    std::optional<BeamStage> beams_;
    std::optional<WallStage> walls_;
    std::optional<AccuracyStage> accuracy_;
    std::optional<PictureStage> picture_;
    Recorder recorder_;
    CheckWatch checks_;
    std::optional<ShallowWatch> shallow_;
    const Surface* surface_ = nullptr;
    FloorMap map_;
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
