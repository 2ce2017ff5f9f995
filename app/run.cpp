#include "app/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/beam_stage.hpp"
#include "app/check_watch.hpp"
#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "app/readings.hpp"
#include "app/recorder.hpp"
#include "app/shallow_watch.hpp"
#include "app/wall_stage.hpp"
#include "caustics/kernels/optics.hpp"
#include "export/report.hpp"
#include "scenarios/build.hpp"
#include "scenarios/reader.hpp"
#include "scenarios/resolve_light.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Adds the time that work takes to a stage.
template <class Work>
void timed(double& stage_s, Work work) {
    const Clock::time_point start = Clock::now();
    work();
    stage_s += std::chrono::duration<double>(Clock::now() - start).count();
}

/// Irradiance (W/m2) on the floor below flat water.
double still_irradiance(const Scenario& s) {
    std::vector<Band> bands = bands_of(s);
    if (bands.empty()) bands.push_back({.optics = s.optics});
    double sum = 0;
    for (const Band& band : bands) {
        const double n = band.optics.refractive_index, fresnel = band.optics.fresnel ? 1 : 0;
        const f64::Refraction r = f64::refract_sun(s.light.direction(), {0, 0}, n, fresnel);
        const double remaining = f64::beer_lambert(band.optics.extinction_per_m(), s.domain.depth_m * r.path);
        sum += band.share * s.light.irradiance_w_m2 * r.incident * r.transmittance * remaining;
    }
    return sum;
}

constexpr double slack = 1e-9;  // of an interval: a duration that is a multiple but for rounding

/// Times after the start: `every` apart, the last at the end.
std::vector<double> times_of(double every, double duration) {
    const int whole = static_cast<int>(std::floor(duration / every + slack));
    std::vector<double> times;
    for (int i = 1; i <= whole; ++i) times.push_back(i * every);
    if (duration - whole * every > slack * every) times.push_back(duration);
    return times;
}

/// A time at which the run stops to look: a frame, or the probes alone.
struct Moment {
    double time_s = 0;
    bool is_frame = true;
};

/// After the start, in order; frames every_s apart, the last at duration_s, and where checks look.
std::vector<Moment> moments_of(const Scenario& s) {
    const double duration = s.waves.duration_s, every = s.output.probe_every_s.value_or(s.output.every_s);
    std::vector<double> times = times_of(s.output.every_s, duration);
    for (const double checked : checked_times(s)) {
        const double room = slack * s.output.every_s;
        const auto next = std::lower_bound(times.begin(), times.end(), checked - room);
        const bool is_there = checked <= room || (next != times.end() && *next <= checked + room);
        if (!is_there) times.insert(next, checked);
    }
    std::vector<Moment> moments;
    for (const double time : times) moments.push_back({time, true});
    if (!s.output.probe_every_s || s.probes.empty()) return moments;
    std::vector<Moment> rows;
    std::size_t frame = 0;
    for (const double time : times_of(every, duration)) {
        while (frame < moments.size() && moments[frame].time_s < time - slack * every) ++frame;
        const bool coincides = frame < moments.size() && moments[frame].time_s <= time + slack * every;
        if (!coincides) rows.push_back({time, false});
    }
    std::vector<Moment> all;
    std::merge(rows.begin(), rows.end(), moments.begin(), moments.end(), std::back_inserter(all),
               [](const Moment& a, const Moment& b) { return a.time_s < b.time_s; });
    return all;
}

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
          checks_(scenario) {
        if (scenario.beams)
            for_section(scenario, "caustics.beams",
                        [&] { beams_.emplace(scenario, waves_, make_beam_renderer(backend_)); });
        if (scenario.walls) walls_.emplace(scenario);
    }

    bool go() {
        const Clock::time_point start = Clock::now();
        const std::vector<Moment> moments = moments_of(scenario_);
        // The first frame is computed before a file is written: what is wrong with the scenario shows by then.
        for_section(scenario_, "caustics", [this] { compute(); });
        checks_.require_references(fields());
        fs::create_directories(out_);
        fs::remove(out_ / "report.json");
        if (waves_.shallow) shallow_.emplace(scenario_, *waves_.shallow, *surface_);
        Outputs outputs(out_, scenario_, still_irradiance(scenario_));
        {
            const auto is_frame = [](const Moment& moment) { return moment.is_frame; };
            const int frames = 1 + static_cast<int>(std::count_if(moments.begin(), moments.end(), is_frame));
            Progress progress(stderr, frames, options_.quiet);
            watch_every_ = (frames + watched_frames - 1) / watched_frames;
            record(0, frames == 1, outputs);
            double now = 0;
            for (const Moment& moment : moments) {
                timed(wall().waves, [&] { waves_.model->advance(moment.time_s - now); });
                now = moment.time_s;
                if (!moment.is_frame) {
                    record_row(now, outputs);
                    continue;
                }
                go_on(now, [this] { compute(); });
                record(now, &moment == &moments.back(), outputs);
                progress.show(recorder_.record().frames);
            }
            end(now, outputs);
            outputs.finish();
        }
        wall().export_busy = outputs.busy_s();
        wall().export_blocked = outputs.blocked_s();
        wall().total = std::chrono::duration<double>(Clock::now() - start).count();
        reject_validation_messages();
        return report(outputs);
    }

  private:
    StageTimes& wall() { return recorder_.record().wall; }

    void look() {
        timed(wall().waves, [&] { surface_ = &waves_.model->surface(); });
        timed(wall().diagnostics, [&] { require_finite(*surface_); });
    }

    void compute() {
        look();
        if (floor_) timed(wall().floor, [&] { floor_->compute(*surface_, map_); });
        if (beams_) timed(wall().beams, [&] { beams_->compute(*surface_); });
        if (walls_) timed(wall().walls, [&] { walls_->compute(*surface_); });
        timed(wall().diagnostics, [&] { require_finite_light(); });
    }

    void require_finite_light() const {
        const double now = surface_->time_s;
        if (floor_) {
            require_finite(map_.irradiance, "the irradiance on the floor", now);
            require_finite(floor_->ledger(map_), "the floor map", now);
        }
        if (beams_) require_finite(beams_->ledger(), "the beams", now);
        if (beams_ && beams_->volume()) {
            require_finite(beams_->volume()->plane_irradiance, "the downward irradiance in the water", now);
            require_finite(beams_->volume()->scalar_irradiance, "the scalar irradiance in the water", now);
        }
        if (beams_ && beams_->image()) require_finite(beams_->image()->radiance, "the radiance of the picture", now);
        if (walls_) require_finite(walls_->maps().ledger, "the walls", now);
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

    /// What is refused once files are written is a failure of the run.
    template <class Work>
    void go_on(double time_s, Work work) {
        try {
            work();
        } catch (const InputError& error) {
            throw WorldError(fmt::format("at t = {} s: {}", time_s, error.what()));
        }
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
                recorder_.add_floor(map_, floor_->ledger(map_), floor_->error_estimate());
                if (last || is_checked) recorder_.add_statistics(map_);
            }
            if (beams_) beams_->add_frame(time_s);
            if (walls_) walls_->add_frame();
            probes = read_probes();
            checks_.add_row(time_s, recorder_.record().probes);
            if (is_checked) add_checked(time_s);
        });
        const FrameFields now = fields();
        const std::span<const BandMap> bands = floor_ ? floor_->bands() : std::span<const BandMap>();
        const WallMaps* walls = walls_ ? &walls_->maps() : nullptr;
        outputs.push({now.surface, now.floor, now.volume, now.picture, walls, bands, ledgers()}, std::move(probes));
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
        go_on(time_s, [this] { compute_for_probes(); });
        std::vector<double> probes;
        timed(wall().diagnostics, [&] { probes = read_probes(); });
        checks_.add_row(time_s, recorder_.record().probes);
        outputs.push_row(time_s, std::move(probes));
    }

    void end(double time_s, Outputs& outputs) {
        if (!shallow_) return;
        timed(wall().diagnostics, [&] { shallow_->finish(*surface_, recorder_.record()); });
        outputs.push_end(surface_->grid, time_s, shallow_->bed_m(), shallow_->records(), shallow_->lines());
    }

    void reject_validation_messages() const {
        if (!backend_.context) return;
        const std::vector<std::string> messages = backend_.context->validation_messages();
        if (!messages.empty())
            throw WorldError(fmt::format("the Vulkan validation layer has {} messages; the first: {}", messages.size(),
                                         messages.front()));
    }

    bool report(const Outputs& outputs) {
        const RunRecord& record = completed();
        const std::vector<CheckResult> checks = judge(scenario_.checks, checks_.values());
        write_json(out_ / "report.json", report_json(scenario_, backend_, record, checks));
        bool all_pass = true;
        for (const CheckResult& check : checks) all_pass = all_pass && (check.pass || check.is_left);
        if (!options_.quiet) say(outputs, checks);
        for (const CheckResult& check : checks)
            if (!check.pass && !check.is_left && options_.quiet) fmt::print(stderr, "{}\n", text_of(check));
        return all_pass;
    }

    static std::string text_of(const CheckResult& check) {
        if (check.is_left)
            return fmt::format("check left to `waterlight check`, which makes other runs: {}, expected {}", check.name,
                               check.expected);
        const std::string within = check.tolerance > 0 ? fmt::format(" within {:.3g}", check.tolerance) : "";
        return fmt::format("check {}: {} is {:.6g}, expected {}{}", check.pass ? "passed" : "FAILED", check.name,
                           check.value, check.expected, within);
    }

    void say(const Outputs& outputs, const std::vector<CheckResult>& checks) {
        const RunRecord& record = recorder_.record();
        fmt::print("{}: {} frame{}, {:.4g} s of water in {:.1f} s, model {}, back-end {}\n",
                   scenario_.title.empty() ? scenario_.origin.file.string() : scenario_.title, record.frames,
                   record.frames == 1 ? "" : "s", record.simulated_s, record.wall.total, record.waves.model,
                   backend_.backend == Backend::vulkan ? "vulkan on " + backend_.device : "cpu");
        for (const CheckResult& check : checks) fmt::print("{}\n", text_of(check));
        for (const std::string& line : outputs.guide()) fmt::print("{}\n", line);
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
    Recorder recorder_;
    CheckWatch checks_;
    std::optional<ShallowWatch> shallow_;
    const Surface* surface_ = nullptr;
    FloorMap map_;
    int watch_every_ = 1;
};

}  // namespace

bool run_scenario(const RunOptions& options) {
    const Scenario scenario = read_scenario(options.scenario, options.overrides);
    if (scenario.decided && !scenario.decided->warning.empty())
        fmt::print(stderr, "waterlight: {}\n", scenario.decided->warning);
    const fs::path out = options.out.empty() ? fs::path("out") / options.scenario.stem() : options.out;
    return Run(options, out, scenario).go();
}

}  // namespace waterlight
