#include "render/scene_renderer.hpp"

#include <algorithm>
#include <chrono>
#include <glm/gtc/packing.hpp>

#include "caustics/phase.hpp"
#include "gpu/buffer.hpp"
#include "gpu/commands.hpp"
#include "render/frame.hpp"
#include "render/kernels/tone.hpp"
#include "render/overlay_map.hpp"
#include "render/passes/basin.hpp"
#include "render/passes/beams.hpp"
#include "render/passes/ground.hpp"
#include "render/passes/sky.hpp"
#include "render/passes/tone.hpp"
#include "render/passes/water.hpp"
#include "render/surface_levels.hpp"

namespace waterlight {

namespace {

constexpr std::uint32_t timed_passes = 128;

/// The colour map whose shades the tone curve will give, as radiance in units of the exposure.
std::vector<glm::vec4> palette_of(Overlay overlay) {
    const ColourMap map = overlay_map(overlay);
    std::vector<glm::vec4> palette(256);
    for (int k = 0; k < 256; ++k) {
        const Rgb c = colour(map, k / 255.0);
        const auto linear = [](std::uint8_t shade) { return f32::filmic_inverse(f32::srgb_decoded(shade / 255.0F)); };
        palette[k] = {linear(c.r), linear(c.g), linear(c.b), 0};
    }
    return palette;
}

std::span<const float> floats(std::span<const glm::vec4> all) { return {&all.data()->x, 4 * all.size()}; }

}  // namespace

struct SceneRenderer::Impl {
    std::shared_ptr<gpu::Context> context;
    std::optional<gpu::Target> radiance, picture;
    SceneBuffers buffers;
    SurfaceLevels surface;
    LightMaps maps;
    WaterPass water;
    GroundPass ground;
    BasinPass basin;
    SkyPass sky;
    BeamsPass beams;
    TonePass tone;
    gpu::Commands commands;
    Storage read_back;
    int asked_samples = 0;
    double exposure = 1;
    std::uint64_t drawn = 0;
    std::vector<StageTime> times;

    explicit Impl(const std::shared_ptr<gpu::Context>& owner)
        : context(owner),
          water(owner),
          ground(owner),
          basin(owner),
          sky(owner),
          beams(owner),
          tone(owner),
          commands(owner, timed_passes) {}

    void fit_targets(const Camera& camera, const Look& look);
    WaterMeshes upload(const Frame& frame);
    void record(const Frame& frame, const WaterMeshes& planned);
    void note_times(double preparing_s);
    template <class Number>
    std::span<const Number> read(const gpu::Target& target);
};

void SceneRenderer::Impl::fit_targets(const Camera& camera, const Look& look) {
    const auto width = static_cast<std::uint32_t>(camera.size.x), height = static_cast<std::uint32_t>(camera.size.y);
    if (picture && picture->width() == width && picture->height() == height && asked_samples == look.samples) return;
    radiance.emplace(
        context, width, height,
        gpu::TargetSettings{
            .format = gpu::Format::rgba16f, .samples = static_cast<std::uint32_t>(look.samples), .depth = true});
    picture.emplace(context, width, height, gpu::TargetSettings{.format = gpu::Format::rgba8});
    asked_samples = look.samples;
}

// What the passes read, to the device.
WaterMeshes SceneRenderer::Impl::upload(const Frame& frame) {
    const Scene& scene = frame.scene;
    fill_levels(*scene.surface, scene.ground_m, surface);
    fill_maps(scene, frame.look.overlay, maps);
    const WaterMeshes planned = plan_water(frame);
    const PhaseTable phase(scene.optics.phase);
    const std::span<const float> volume =
        scene.volume != nullptr ? scene.volume->scalar_irradiance.values() : std::span<const float>{};
    const double depth = frame.variant.in_water ? std::max(0.0, -frame.eye().z) : 0;
    const SceneParameters block =
        scene_parameters(scene, frame.look, surface, maps, static_cast<int>(phase.values().size()), depth);
    exposure = 1 / block.per_exposure;
    const std::vector<float> heights =
        scene.ground_m != nullptr ? padded_ground(*scene.surface, *scene.ground_m) : std::vector<float>{};
    reserve(context, buffers.block, sizeof block, gpu::BufferUse::from_host);
    buffers.block->host<SceneParameters>()[0] = block;
    commands.upload(*buffers.block);
    write(context, buffers.surface, {floats(surface.cells)}, commands);
    write(context, buffers.light, {maps.values}, commands);
    write(context, buffers.medium, {phase.values(), volume}, commands);
    write(context, buffers.ground, {heights}, commands);
    write(context, buffers.copies, {floats(planned.shifts)}, commands);
    write(context, buffers.palette, {floats(palette_of(frame.look.overlay))}, commands);
    if (BeamsPass::needed(frame)) write(context, buffers.beams, {scene.beams->radiance.values()}, commands);
    return planned;
}

// The picture, pass by pass. What is nearest hides most, so the water comes first and the sky last, which leaves no
// pixel undrawn.
void SceneRenderer::Impl::record(const Frame& frame, const WaterMeshes& planned) {
    commands.discard(*radiance);
    water.record(frame, planned);
    if (GroundPass::needed(frame)) ground.record(frame, planned);
    if (BasinPass::needed(frame)) basin.record(frame);
    sky.record(frame);
    if (BeamsPass::needed(frame)) beams.record(frame);
    commands.discard(*picture);
    tone.record(frame);
}

void SceneRenderer::Impl::note_times(double preparing_s) {
    times.assign(1, {"prepare", preparing_s});
    for (const gpu::Timing& t : commands.timings()) {
        const auto same = std::ranges::find(times, t.pass, &StageTime::stage);
        if (same != times.end())
            same->seconds += t.seconds;
        else
            times.push_back({t.pass, t.seconds});
    }
}

template <class Number>
std::span<const Number> SceneRenderer::Impl::read(const gpu::Target& target) {
    reserve(context, read_back, target.bytes(), gpu::BufferUse::to_host);
    commands.copy(target, *read_back);
    commands.download(*read_back);
    commands.run();
    return read_back->host<Number>().first(target.bytes() / sizeof(Number));
}

SceneRenderer::SceneRenderer(std::shared_ptr<gpu::Context> context) : impl_(std::make_unique<Impl>(context)) {}

SceneRenderer::~SceneRenderer() = default;

void SceneRenderer::draw(const Scene& scene, const Look& look, const Camera& camera) {
    validate(scene, look, camera);
    Impl& m = *impl_;
    const auto start = std::chrono::steady_clock::now();
    m.fit_targets(camera, look);
    const Frame frame{.scene = scene,
                      .look = look,
                      .camera = camera,
                      .variant = variant_of(scene, look, camera.position_m),
                      .view = view_parameters(camera),
                      .surface = m.surface,
                      .buffers = m.buffers,
                      .commands = m.commands,
                      .radiance = *m.radiance,
                      .picture = *m.picture,
                      .number = ++m.drawn};
    const WaterMeshes planned = m.upload(frame);
    m.record(frame, planned);
    const std::chrono::duration<double> preparing = std::chrono::steady_clock::now() - start;
    m.commands.run();
    m.note_times(preparing.count());
}

const gpu::Target& SceneRenderer::picture() const { return *impl_->picture; }

std::vector<std::uint8_t> SceneRenderer::read_picture() {
    const std::span<const std::uint8_t> all = impl_->read<std::uint8_t>(*impl_->picture);
    return {all.begin(), all.end()};
}

Radiance SceneRenderer::read_radiance() {
    const gpu::Target& from = *impl_->radiance;
    impl_->commands.resolve(from);
    const std::span<const std::uint16_t> halves = impl_->read<std::uint16_t>(from);
    Radiance radiance;
    radiance.size = {from.width(), from.height()};
    radiance.rgb.reserve(3 * halves.size() / 4);
    for (std::size_t k = 0; k < halves.size(); ++k)
        if (k % 4 != 3) radiance.rgb.push_back(glm::unpackHalf1x16(halves[k]) * static_cast<float>(impl_->exposure));
    return radiance;
}

const std::vector<StageTime>& SceneRenderer::stage_times() const { return impl_->times; }

}  // namespace waterlight
