#include "app/sweep/measure.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <functional>
#include <new>

#include "app/moments.hpp"
#include "app/readings.hpp"
#include "app/sweep/raster.hpp"
#include "app/sweep/store.hpp"
#include "app/timed.hpp"
#include "export/atomic_file.hpp"
#include "gpu/error.hpp"

namespace waterlight {

namespace {

/// Called at the k-th judged time; `map` is null without a floor.
using Judge = std::function<void(std::size_t k, const Surface& surface, const FloorMap* map)>;

/// A run that only computes: its frames are timed, and it also stops, untimed, where it is judged.
class BareRun {
  public:
    BareRun(const Scenario& scenario, const BackendDecision& backend)
        : scenario_(scenario),
          waves_(build_model(scenario, backend.context)),
          floor_(scenario.floor ? make_floor_stage(scenario, waves_, backend) : nullptr) {}

    SettingTimes go(const std::vector<double>& judged_s, const Judge& judge) {
        std::size_t k = 0;
        for (const Moment& moment : moments_of(scenario_)) {
            if (!moment.is_frame) continue;
            for (; judge && k < judged_s.size() && judged_s[k] < moment.time_s * (1 - slack); ++k) {
                advance(judged_s[k]);
                SettingTimes between;
                light(between);
                judge(k, *surface_, floor_ ? &map_ : nullptr);
            }
            if (moment.time_s > now_s_) advance(moment.time_s);
            frame();
            if (judge && k < judged_s.size() && judged_s[k] <= moment.time_s * (1 + slack))
                judge(k++, *surface_, floor_ ? &map_ : nullptr);
        }
        return times_;
    }
    int frames() const { return frames_; }

  private:
    static constexpr double slack = 1e-9;  // of a time: rounding

    void advance(double time_s) {
        timed(times_.waves, [&] { waves_.model->advance(time_s - now_s_); });
        now_s_ = time_s;
    }
    void light(SettingTimes& times) {
        timed(times.waves, [&] { surface_ = &waves_.model->surface(); });
        require_finite(*surface_, waves_.model->steps());
        if (floor_) timed(times.floor, [&] { floor_->compute(*surface_, map_); });
    }
    void frame() {
        light(times_);
        ++frames_;
    }

    const Scenario& scenario_;
    BuiltModel waves_;
    std::unique_ptr<FloorStage> floor_;
    const Surface* surface_ = nullptr;
    FloorMap map_;
    SettingTimes times_;
    double now_s_ = 0;
    int frames_ = 0;
};

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

void run(const SweepOptions& options, const Comparison& comparison, const Setting& setting, const Judge& judge,
         SettingResult& result) {
    const BackendDecision backend = choose_backend(options.device, setting.scenario);
    result.backend = backend.backend == Backend::vulkan ? "vulkan" : "cpu";
    result.device = backend.device;
    std::vector<double> waves, floor;
    for (int n = 0; n < options.repeats; ++n) {
        BareRun bare(setting.scenario, backend);
        const SettingTimes times = bare.go(comparison.times_s, n == 0 ? judge : Judge());
        waves.push_back(times.waves);
        floor.push_back(times.floor);
        result.frames = bare.frames();
    }
    result.wall_s = {median(waves), median(floor)};
}

}  // namespace

SettingResult measure(const SweepOptions& options, const Comparison& comparison, const Setting& setting,
                      const Reference& reference, const std::filesystem::path& truth) {
    RelativeError waves, light, both;
    const Judge judge = [&](std::size_t k, const Surface& surface, const FloorMap* map) {
        waves.add(elevations(surface, comparison.points), reference.elevation_m[k]);
        if (!map) return;
        const Field<float> found = averaged(map->irradiance, comparison.raster);
        both.add(found, reference.irradiance[k]);
        light.add(found, kept_field(fmt::format("{}_{:03}.vti", truth.string(), k), "irradiance", [&] {
                      return truth_on(setting.scenario, comparison.raster, interpolate(surface),
                                      options.truth_tolerance)
                          .irradiance;
                  }));
    };
    SettingResult result;
    result.overrides = setting.overrides;
    result.threads = omp_get_max_threads();
    result.reference = reference.description;
    try {
        run(options, comparison, setting, judge, result);
        result.errors = {waves.value(), light.value(), both.value()};
    } catch (const WriteError&) {
        throw;
    } catch (const std::bad_alloc&) {
        result.failed = "out of memory";
    } catch (const std::runtime_error& error) {
        result.failed = error.what();
    }
    return result;
}

}  // namespace waterlight
