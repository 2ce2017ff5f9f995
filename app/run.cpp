#include "app/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/beam_stage.hpp"
#include "app/moments.hpp"
#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "app/readings.hpp"
#include "app/recorder.hpp"
#include "app/shallow_watch.hpp"
#include "caustics/kernels/optics.hpp"
#include "export/report.hpp"
#include "scenarios/build.hpp"
#include "scenarios/reader.hpp"
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
    const double n = s.optics.refractive_index, fresnel = s.optics.fresnel ? 1 : 0;
    const f64::Refraction r = f64::refract_sun(s.light.direction(), {0, 0}, n, fresnel);
    const double remaining = f64::beer_lambert(s.optics.extinction_per_m(), s.domain.depth_m * r.path);
    return s.light.irradiance_w_m2 * r.incident * r.transmittance * remaining;
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
          floor_(scenario.floor ? make_floor_stage(scenario, waves_, backend_) : nullptr),
          recorder_(scenario) {
        if (scenario.beams) beams_.emplace(scenario);
        if (scenario.accuracy.estimate) accuracy_.emplace(scenario, waves_, backend_);
    }

    bool go() {
        const Clock::time_point start = Clock::now();
        const std::vector<Moment> moments = moments_of(scenario_);
        // The first frame is computed before a file is written: what is wrong with the scenario shows by then.
        for_section(scenario_, "caustics", [this] { compute(); });
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
                if (accuracy_) timed(wall().accuracy, [&] { accuracy_->advance(moment.time_s - now); });
                now = moment.time_s;
                if (!moment.is_frame) {
                    record_row(now, outputs);
                    continue;
                }
                compute_further(now);
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
        if (accuracy_) timed(wall().accuracy, [&] { accuracy_->compute(*surface_, floor_ ? &map_ : nullptr); });
    }

    /// As a probe reads it: in the water, or on the floor.
    double irradiance_at(const Probe& probe) const {
        if (probe.depth_m) return beams_->irradiance_at(probe.at_m, *probe.depth_m);
        return floor_ ? floor_->irradiance_at(*surface_, map_, probe.at_m) : std::numeric_limits<double>::quiet_NaN();
    }

    /// What is refused once files are written is a failure of the run.
    void compute_further(double time_s) {
        try {
            compute();
        } catch (const InputError& error) {
            throw WorldError(fmt::format("at t = {} s: {}", time_s, error.what()));
        }
    }

    void record(double time_s, bool last, Outputs& outputs) {
        std::vector<double> probes;
        timed(wall().diagnostics, [&] {
            const bool watched = last || recorder_.record().frames % watch_every_ == 0;
            if (watched) recorder_.add_waves(time_s, waves_.model->diagnostics());
            if (shallow_) shallow_->add_frame(*surface_);
            if (shallow_ && watched) shallow_->add_totals();
            recorder_.add_frame(time_s);
            if (floor_) {
                recorder_.add_floor(map_, floor_->error_estimate());
                if (last) recorder_.add_statistics(map_);
            }
            if (beams_) beams_->add_frame();
            probes = recorder_.add_probes(*surface_, [this](const Probe& probe) { return irradiance_at(probe); });
        });
        const BeamVolume* volume = beams_ ? beams_->volume() : nullptr;
        const BeamImage* picture = beams_ ? beams_->image() : nullptr;
        FrameView view{*surface_, floor_ ? &map_ : nullptr, volume, picture};
        if (accuracy_) view.floor_error = accuracy_->floor_error();
        if (accuracy_) view.waves_error = accuracy_->waves_error();
        outputs.push(view, std::move(probes));
    }

    void record_row(double time_s, Outputs& outputs) {
        look();
        std::vector<double> probes;
        timed(wall().diagnostics, [&] { probes = recorder_.add_probes(*surface_, {}); });
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
        RunRecord& record = recorder_.record();
        record.waves.model = waves_.model->name();
        record.waves.steps = waves_.model->steps();
        if (beams_) record.beams = beams_->record();
        if (accuracy_) {
            record.accuracy = accuracy_->record();
            if (record.floor && std::isfinite(record.floor->truth_error))
                record.accuracy->floor_rmse = record.floor->truth_error;
        }
        if (waves_.airy && !waves_.sea.empty()) record.sea = SeaRecord{waves_.airy->sea_coverage(), waves_.sea};
        const std::vector<CheckResult> checks = judge(scenario_.checks, quantities_of(record));
        write_json(out_ / "report.json", report_json(scenario_, backend_, record, checks));
        bool all_pass = true;
        for (const CheckResult& check : checks) all_pass = all_pass && check.pass;
        if (!options_.quiet) say(outputs, checks);
        for (const CheckResult& check : checks)
            if (!check.pass && options_.quiet) fmt::print(stderr, "{}\n", text_of(check));
        return all_pass;
    }

    static std::string text_of(const CheckResult& check) {
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
    std::optional<AccuracyStage> accuracy_;
    Recorder recorder_;
    std::optional<ShallowWatch> shallow_;
    const Surface* surface_ = nullptr;
    FloorMap map_;
    int watch_every_ = 1;
};

}  // namespace

bool run_scenario(const RunOptions& options) {
    const Scenario scenario = read_scenario(options.scenario, options.overrides);
    const fs::path out = options.out.empty() ? fs::path("out") / options.scenario.stem() : options.out;
    return Run(options, out, scenario).go();
}

}  // namespace waterlight
