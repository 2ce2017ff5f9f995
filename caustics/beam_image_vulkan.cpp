#include "caustics/beam_image_vulkan.hpp"

#include <array>
#include <bit>
#include <optional>

#include "caustics/beam_buffers.hpp"
#include "caustics/beam_picture.hpp"
#include "caustics/phase.hpp"
#include "caustics/water_box.hpp"
#include "gpu/buffer.hpp"
#include "gpu/commands.hpp"
#include "gpu/pass.hpp"
#include "gpu/raster.hpp"
#include "shaders/beam_cells.hpp"
#include "shaders/beam_light.hpp"
#include "shaders/beam_outline.hpp"

namespace waterlight {

namespace {

#include "caustics/shaders/beam_image_parameters.glsl"

using gpu::BufferUse;

constexpr std::array<std::uint32_t, 3> cell_workgroup{64, 1, 1};
constexpr std::size_t record_bytes = 14 * 4 * sizeof(float);  // of a CellRecord
constexpr std::uint32_t outline_corners = 8;
constexpr std::uint32_t timed_passes = 64;  // of all copies of the beams: those of the first

BeamCellParameters cell_parameters(const BeamImageSettings& s, const Beams& beams) {
    const Viewpoint view(s.camera);
    const glm::vec3 eye(view.eye_m), corner(view.rays.corner), right(view.rays.right), up(view.rays.up);
    const glm::vec3 forward(view.rays.forward);
    return {.eye_x = eye.x,
            .eye_y = eye.y,
            .eye_z = eye.z,
            .corner_x = corner.x,
            .corner_y = corner.y,
            .corner_z = corner.z,
            .right_x = right.x,
            .right_y = right.y,
            .right_z = right.z,
            .up_x = up.x,
            .up_y = up.y,
            .up_z = up.z,
            .forward_x = forward.x,
            .forward_y = forward.y,
            .forward_z = forward.z,
            .shift_x = 0,
            .shift_y = 0,
            .range = static_cast<float>(s.range_m),
            .scattering = static_cast<float>(s.optics.scattering_per_m),
            .nx = beams.nx,
            .ny = beams.ny,
            .width = s.camera.size.x,
            .height = s.camera.size.y};
}

BeamPixelParameters pixel_parameters(const BeamImageSettings& s, const Beams& beams) {
    const Viewpoint view(s.camera);
    const ViewRays rays(view.rays);
    const WaterBox box(beams, view.eye_m);
    return {.corner_x = rays.corner.x,
            .corner_y = rays.corner.y,
            .corner_z = rays.corner.z,
            .right_x = rays.right.x,
            .right_y = rays.right.y,
            .right_z = rays.right.z,
            .up_x = rays.up.x,
            .up_y = rays.up.y,
            .up_z = rays.up.z,
            .low_x = box.low.x,
            .low_y = box.low.y,
            .low_z = box.low.z,
            .high_x = box.high.x,
            .high_y = box.high.y,
            .high_z = box.high.z,
            .range = static_cast<float>(s.range_m),
            .extinction = static_cast<float>(beams.extinction_per_m),
            .mean_cosine = static_cast<float>(s.optics.phase.g),
            .samples = s.samples,
            .width = s.camera.size.x,
            .height = s.camera.size.y};
}

/// What of the fragment shader is compiled in.
struct Variant {
    bool tabulated = false;   ///< the phase function
    bool uneven = false;      ///< where beams end
    bool ends_early = false;  ///< rays, on ground
    std::vector<std::uint32_t> constants() const { return {tabulated, uneven, ends_early}; }
    std::size_t index() const { return (tabulated ? 1U : 0U) + (uneven ? 2U : 0U) + (ends_early ? 4U : 0U); }
};

}  // namespace

struct BeamImageVulkan::Impl {
    std::shared_ptr<gpu::Context> context;
    gpu::Pass view_cells;
    std::array<std::optional<gpu::Raster>, 8> light;  // by variant, made when first used
    std::optional<gpu::Target> target;
    BeamBuffers beams;
    Storage cells, counts, phase, reach, pixels;
    gpu::Commands commands;
    std::vector<StageTime> times;

    explicit Impl(std::shared_ptr<gpu::Context> owner)
        : context(std::move(owner)),
          view_cells(context, {"cells", shaders::beam_cells, 4, sizeof(BeamCellParameters), cell_workgroup}),
          commands(context, timed_passes) {
        make_light({});
    }

    gpu::Raster& make_light(const Variant& variant) {
        std::optional<gpu::Raster>& raster = light[variant.index()];
        if (!raster)
            raster.emplace(context, gpu::RasterSettings{"light", shaders::beam_outline, shaders::beam_light, 3,
                                                        sizeof(BeamPixelParameters), variant.constants()});
        return *raster;
    }

    /// Draws without reduction; adds to the times.
    void draw(const BeamImageSettings& s, const Beams& b, const Field<float>& ways, BeamImage& image) {
        const bool tabulated = s.optics.phase.type != Phase::Type::henyey_greenstein;
        const glm::ivec2 size = s.camera.size;
        const auto width = static_cast<std::uint32_t>(size.x), height = static_cast<std::uint32_t>(size.y);
        if (!target || target->width() != width || target->height() != height) target.emplace(context, width, height);
        beams.write(context, b, commands);
        write(context, reach, {ways.values()}, commands);
        const PhaseTable table(s.optics.phase);
        write(context, phase, {tabulated ? table.values() : std::span<const float>{}}, commands);
        const std::size_t cell_count = b.flux.size() / 2;
        reserve(context, cells, record_bytes * cell_count, BufferUse::device);
        reserve(context, counts, sizeof(std::uint32_t), BufferUse::to_host);
        reserve(context, pixels, sizeof(float) * width * height, BufferUse::to_host);
        record(s, b, make_light({tabulated, !ends_level(b), !ways.empty()}));
        commands.run();
        read(s, image);
        for (const gpu::Timing& t : commands.timings()) times[t.pass == "cells" ? 0 : 1].seconds += t.seconds;
    }

    void record(const BeamImageSettings& s, const Beams& b, gpu::Raster& raster) {
        view_cells.bind({&*beams.corners, &*beams.flux, &*cells, &*counts});
        raster.bind({&*cells, &*phase, &*reach});
        commands.clear(*counts);
        commands.clear(*target);
        BeamCellParameters cell_push = cell_parameters(s, b);
        const BeamPixelParameters pixel_push = pixel_parameters(s, b);
        const auto nx = static_cast<std::uint32_t>(b.nx), ny = static_cast<std::uint32_t>(b.ny);
        for (const glm::vec2 shift : copies_in_sight(s, b)) {
            cell_push.shift_x = shift.x;
            cell_push.shift_y = shift.y;
            commands.dispatch(view_cells, {nx, ny, 1}, cell_push);
            commands.draw(raster, *target, {nx * ny, outline_corners}, pixel_push);
        }
        commands.copy(*target, *pixels);
        commands.download(*pixels);
        commands.download(*counts);
    }

    void read(const BeamImageSettings& s, BeamImage& image) const {
        resize(s, image);
        const std::span<const float> all = pixels->host<float>().first(image.radiance.size());
        std::ranges::copy(all, image.radiance.data());
        image.counts = {counts->host<std::uint32_t>()[0], std::ranges::count_if(all, [](float l) { return l > 0; }), 0};
    }
};

BeamImageVulkan::BeamImageVulkan(std::shared_ptr<gpu::Context> context)
    : impl_(std::make_unique<Impl>(std::move(context))) {}

BeamImageVulkan::~BeamImageVulkan() = default;

void BeamImageVulkan::draw(const BeamImageSettings& settings, const Beams& beams, BeamImage& image) {
    validate(settings, beams);
    impl_->times = {{"cells", 0}, {"light", 0}};
    draw_reduced(
        settings, beams,
        [&](const BeamImageSettings& all, const Beams& some, const Field<float>& reach, BeamImage& out) {
            impl_->draw(all, some, reach, out);
        },
        image);
}

const std::vector<StageTime>& BeamImageVulkan::stage_times() const { return impl_->times; }

}  // namespace waterlight
