// frame/vulkan/1280x720/SCENE: all that one frame takes, waves first. The time and frames_per_s are those of
// everything. Counters (ms): waves; floor map; beams, made and drawn at half the frame's pixels each way; the picture;
// and of it each pass by the device's clock as pass_NAME_ms, pass_prepare_ms by the host's, and pass_none_ms in none of
// them.
//
// pool: from beside it, below its rim, with shafts. pool_above: from above. sea: from a deck, to the horizon.
// sea_below: upwards, with shafts.
#include "tests/bench/frame.hpp"

#include <benchmark/benchmark.h>

#include <chrono>
#include <map>
#include <string>

#include "caustics/beam_renderer_vulkan.hpp"
#include "caustics/floor_vulkan.hpp"
#include "render/scene_renderer.hpp"
#include "sim/airy.hpp"

namespace waterlight::bench {

namespace {

constexpr glm::ivec2 frame_size{1280, 720};

struct FrameCase {
    std::string name;
    AirySettings waves;
    WaterOptics optics;
    Camera camera;
    glm::ivec2 floor_pixels{0, 0};  ///< 0: no floor map
    glm::ivec2 beam_cells{0, 0};    ///< 0: no beams
};

Camera camera_at(glm::dvec3 from, glm::dvec3 to, double fov_deg) {
    Camera camera;
    camera.position_m = from;
    camera.target_m = to;
    camera.fov_deg = fov_deg;
    camera.size = frame_size;
    return camera;
}

AirySettings pool_waves() {
    AirySettings s;
    s.grid = make_grid(256, 192, 8, 6);
    s.boundary = {Side::wall, Side::wall};
    s.water.depth_m = 2;
    s.sources = {Drop{{2.6, 2.1}, 0.16, 0.06, 0}, Drop{{5.6, 3.9}, 0.13, 0.045, 0.4},
                 Drop{{4.1, 1.2}, 0.1, -0.03, 0.9}};
    return s;
}

AirySettings sea_waves() {
    AirySettings s;
    s.grid = make_grid(256, 256, 32, 32);
    s.boundary = {Side::periodic, Side::periodic};
    s.water.depth_m = 16;
    SpectrumSettings spectrum;
    spectrum.significant_height_m = 0.4;
    spectrum.peak_period_s = 3;
    s.sea = Sea{make_spectrum(spectrum, s.water), 1};
    return s;
}

std::vector<FrameCase> cases() {
    WaterOptics clear;
    clear.absorption_per_m = 0.05;
    WaterOptics turbid = clear;
    turbid.scattering_per_m = 0.05;
    return {{"pool", pool_waves(), turbid, camera_at({4, -4.5, -0.9}, {4, 2, -1.05}, 40), {512, 384}, {128, 96}},
            {"pool_above", pool_waves(), clear, camera_at({4, -3, 4}, {4, 2.6, -0.6}, 50), {512, 384}},
            {"sea", sea_waves(), turbid, camera_at({10, 14, 2.5}, {20, 17, 1.6}, 55)},
            {"sea_below", sea_waves(), turbid, camera_at({10, 14, -6}, {15, 16.3, -0.4}, 75), {}, {128, 128}}};
}

/// Seconds by stage, summed over frames.
class StageSeconds {
  public:
    template <class Work>
    void time(const std::string& stage, Work work) {
        const auto start = std::chrono::steady_clock::now();
        work();
        seconds_[stage] += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    void add(const StageTime& pass) { seconds_["pass_" + pass.stage] += pass.seconds; }
    void count(benchmark::State& state) {
        double none = seconds_["picture"];
        for (const auto& [stage, s] : seconds_)
            if (stage.starts_with("pass_")) none -= s;
        seconds_["pass_none"] = none;
        for (const auto& [stage, s] : seconds_)
            state.counters[stage + "_ms"] = benchmark::Counter(1e3 * s, benchmark::Counter::kAvgIterations);
        state.counters["frames_per_s"] = benchmark::Counter(1, benchmark::Counter::kIsIterationInvariantRate);
    }

  private:
    std::map<std::string, double> seconds_;
};

/// A scene that moves, and what is made of it frame by frame.
class Frames {
  public:
    Frames(const FrameCase& c, const std::shared_ptr<gpu::Context>& context)
        : case_(c), waves_(make_airy(c.waves)), renderer_(context) {
        const bool on_cpu = context->device().type == gpu::DeviceType::cpu;
        scene_.depth_m = c.waves.water.depth_m;
        scene_.sun = sun;
        scene_.optics = c.optics;
        if (c.floor_pixels.x > 0) {
            FloorSettings s;
            s.plan = scene_.floor_plan = cover(c.waves.grid, c.floor_pixels.x, c.floor_pixels.y);
            s.depth_m = scene_.depth_m;
            s.sun = sun;
            s.optics = c.optics;
            mapper_ = on_cpu ? make_floor_cpu(s) : make_floor_vulkan(s, context);
        }
        if (c.beam_cells.x > 0) beam_renderer_ = on_cpu ? make_beam_renderer_cpu() : make_beam_renderer_vulkan(context);
        // Rings and shafts have spread by then, and buffers have their sizes.
        waves_->advance(1.5);
        StageSeconds ignored;
        frame(ignored);
    }

    void frame(StageSeconds& times) {
        times.time("waves", [this] {
            waves_->advance(1.0 / 60);
            scene_.surface = &waves_->surface();
        });
        if (mapper_) times.time("floor", [this] { map_floor(); });
        if (beam_renderer_) times.time("beams", [this] { draw_beams(); });
        times.time("picture", [this] { renderer_.draw(scene_, look_, case_.camera); });
        for (const StageTime& pass : renderer_.stage_times()) times.add(pass);
    }

  private:
    static constexpr Sun sun{60, 30, 1000};

    void map_floor() {
        mapper_->compute(*scene_.surface, map_);
        scene_.floor = &map_.irradiance;
    }

    void draw_beams() {
        BeamSettings settings;
        settings.grid = case_.beam_cells;
        settings.depth_m = scene_.depth_m;
        settings.sun = sun;
        settings.optics = case_.optics;
        make_beams(settings, *scene_.surface, beams_);
        BeamImageSettings picture;
        picture.camera = case_.camera;
        picture.camera.size /= 2;
        picture.optics = case_.optics;
        picture.range_m = 24;
        beam_renderer_->draw(picture, beams_, image_);
        scene_.beams = &image_;
    }

    FrameCase case_;
    std::unique_ptr<AiryModel> waves_;
    std::unique_ptr<FloorMapper> mapper_;
    std::unique_ptr<BeamRenderer> beam_renderer_;
    FloorMap map_;
    Beams beams_;
    BeamImage image_;
    Scene scene_;
    Look look_;
    SceneRenderer renderer_;
};

void frames(benchmark::State& state, const FrameCase& c, const std::shared_ptr<gpu::Context>& context) {
    Frames all(c, context);
    StageSeconds times;
    for (auto _ : state) all.frame(times);
    times.count(state);
}

}  // namespace

void register_frames(const std::shared_ptr<gpu::Context>& context) {
    for (const FrameCase& c : cases()) {
        const std::string name = "frame/vulkan/1280x720/" + c.name;
        benchmark::RegisterBenchmark(name.c_str(), [c, context](benchmark::State& state) { frames(state, c, context); })
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime();
    }
}

}  // namespace waterlight::bench
