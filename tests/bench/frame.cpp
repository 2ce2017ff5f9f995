// frame/vulkan/1280x720/SCENE: one picture of moving water with all that it shows: waves, floor map and beams on the
// CPU, the picture on the device. Counters: milliseconds of each stage and of each pass of the picture, and whole
// frames a second.
#include "tests/bench/frame.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "render/scene_renderer.hpp"
#include "sim/airy.hpp"

namespace waterlight::bench {

namespace {

constexpr double frame_s = 1.0 / 30;

/// What a frame is made of; members are made anew from the surface in each.
class Frames {
  public:
    Frames(const std::shared_ptr<gpu::Context>& context, Side side, glm::dvec2 size_m, glm::ivec2 cells, double depth_m)
        : renderer_(context), beam_renderer_(make_beam_renderer_cpu()) {
        waves_.grid = make_grid(cells.x, cells.y, size_m.x, size_m.y);
        waves_.boundary = {side, side};
        waves_.water.depth_m = depth_m;
        scene_.depth_m = depth_m;
        scene_.sun = {.elevation_deg = 60, .azimuth_deg = 30, .irradiance_w_m2 = 1000};
        camera_.size = {1280, 720};
    }

    void next(benchmark::State& state) {
        timed("waves", [&] {
            model_->advance(frame_s);
            scene_.surface = &model_->surface();
        });
        if (floor_) timed("floor", [&] { floor_->compute(*scene_.surface, map_); });
        timed("beams", [&] { light_water(); });
        timed("picture", [&] { renderer_.draw(scene_, look_, camera_); });
        for (const StageTime& pass : renderer_.stage_times()) seconds_["pass_" + pass.stage] += pass.seconds;
        benchmark::DoNotOptimize(state.iterations());
    }

    void count(benchmark::State& state) const {
        for (const auto& [stage, s] : seconds_)
            state.counters[stage + "_ms"] = benchmark::Counter(1e3 * s, benchmark::Counter::kAvgIterations);
        state.counters["frames_per_s"] = benchmark::Counter(1, benchmark::Counter::kIsIterationInvariantRate);
    }

  protected:
    virtual void light_water() = 0;
    ~Frames() = default;

    void light_floor(int width, int height) {
        FloorSettings settings;
        settings.plan = cover(waves_.grid, width, height);
        settings.depth_m = scene_.depth_m;
        settings.sun = scene_.sun;
        settings.optics = scene_.optics;
        floor_ = make_floor_cpu(settings);
        scene_.floor = &map_.irradiance;
        scene_.floor_plan = settings.plan;
    }

    BeamSettings beam_settings(glm::ivec2 grid) const {
        BeamSettings settings;
        settings.grid = grid;
        settings.depth_m = scene_.depth_m;
        settings.sun = scene_.sun;
        settings.optics = scene_.optics;
        return settings;
    }

    template <class Work>
    void timed(const std::string& stage, Work work) {
        const auto start = std::chrono::steady_clock::now();
        work();
        seconds_[stage] += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    AirySettings waves_;
    std::unique_ptr<AiryModel> model_;
    std::unique_ptr<FloorMapper> floor_;
    FloorMap map_;
    Beams beams_;
    Scene scene_;
    Look look_;
    Camera camera_;
    SceneRenderer renderer_;
    std::unique_ptr<BeamRenderer> beam_renderer_;
    std::map<std::string, double> seconds_;
};

/// A pool from above: 256 x 192 cells, a map of 512 x 384 pixels, light in the water as fields of half the beams' grid.
class PoolFromAbove final : public Frames {
  public:
    explicit PoolFromAbove(const std::shared_ptr<gpu::Context>& context)
        : Frames(context, Side::wall, {8, 6}, {256, 192}, 2) {
        waves_.sources = {Drop{{2.6, 2.1}, .16, .06, 0}, Drop{{5.6, 3.9}, .13, .045, .1},
                          Drop{{4.1, 1.2}, .1, -.03, .2}};
        model_ = make_airy(waves_);
        model_->advance(1);
        scene_.optics.absorption_per_m = scene_.optics.scattering_per_m = .02;
        light_floor(512, 384);
        camera_.position_m = {4, -4.5, 5};
        camera_.target_m = {4, 2.6, -1};
        scene_.volume = &volume_;
    }

  private:
    void light_water() override {
        make_beams(beam_settings({128, 96}), *scene_.surface, beams_);
        beam_renderer_->fill(beams_, {64, 48, 16}, volume_);
    }
    BeamVolume volume_;
};

/// A sea from below, with the beams' picture at half its size; its floor is dark.
class OpenSea final : public Frames {
  public:
    explicit OpenSea(const std::shared_ptr<gpu::Context>& context)
        : Frames(context, Side::periodic, {32, 32}, {256, 256}, 16) {
        const SpectrumSettings wind{.significant_height_m = .5, .peak_period_s = 3.5};
        waves_.sea = waterlight::Sea{make_spectrum(wind, waves_.water)};
        model_ = make_airy(waves_);
        scene_.optics.absorption_per_m = .114;
        scene_.optics.scattering_per_m = .037;
        look_.floor.pattern = Finish::Pattern::sand;
        camera_.position_m = {10, 14, -6};
        camera_.target_m = {15, 16.33, -.4};
        camera_.fov_deg = 75;
        scene_.beams = &picture_;
    }

  private:
    void light_water() override {
        make_beams(beam_settings({128, 128}), *scene_.surface, beams_);
        BeamImageSettings settings;
        settings.camera = camera_;
        settings.camera.size = camera_.size / 2;
        settings.optics = scene_.optics;
        settings.range_m = 24;
        beam_renderer_->draw(settings, beams_, picture_);
    }
    BeamImage picture_;
};

template <class Scene>
void frames(benchmark::State& state, const std::shared_ptr<gpu::Context>& context) {
    Scene scene(context);
    for (auto _ : state) scene.next(state);
    scene.count(state);
}

}  // namespace

void register_frames(const std::shared_ptr<gpu::Context>& context) {
    const auto add = [&](const char* name, auto run) {
        benchmark::RegisterBenchmark(name, [=](benchmark::State& state) { run(state, context); })
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime();
    };
    add("frame/vulkan/1280x720/pool", frames<PoolFromAbove>);
    add("frame/vulkan/1280x720/sea", frames<OpenSea>);
}

}  // namespace waterlight::bench
