// The floor map on a Vulkan device: the passes of Yuksel & Keyser (2009) as compute shaders. The M + 1 channels of
// pass 1 lie in a storage buffer instead of render targets, so M is free; the lattice is handled in bands of rows, so
// that their memory is bounded.
#include "caustics/floor_vulkan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "caustics/floor_frame.hpp"
#include "caustics/floor_samples.hpp"
#include "caustics/kernels/surface_lookup.hpp"
#include "caustics/object_shadows.hpp"
#include "gpu/buffer.hpp"
#include "gpu/commands.hpp"
#include "gpu/pass.hpp"
#include "shaders/floor_gather.hpp"
#include "shaders/floor_gather_adaptive.hpp"
#include "shaders/floor_land.hpp"
#include "shaders/floor_land_shaded.hpp"
#include "shaders/floor_sum.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

#include "caustics/shaders/floor_parameters.glsl"

using gpu::BufferUse;

constexpr std::int64_t band_bytes = std::int64_t{1} << 27;  // of channels, and of landed samples
constexpr std::array<std::uint32_t, 3> row_workgroup{64, 1, 1};
constexpr std::array<std::uint32_t, 3> tile_workgroup{32, 8, 1};

FloorParameters parameters(const FloorFrame& frame, const Surface& surface) {
    const f32::FloorLight& light = frame.light;
    return {.direction_x = light.direction.x,
            .direction_y = light.direction.y,
            .direction_z = light.direction.z,
            .irradiance = light.irradiance,
            .index = light.index,
            .fresnel = light.fresnel,
            .depth = light.depth,
            .extinction = frame.extinction_per_m,
            .rest_travel_x = light.rest_travel.x,
            .rest_travel_y = light.rest_travel.y,
            .pixel_x_x = light.pixel_x.x,
            .pixel_x_y = light.pixel_x.y,
            .pixel_y_x = light.pixel_y.x,
            .pixel_y_y = light.pixel_y.y,
            .nx = surface.grid.nx,
            .ny = surface.grid.ny,
            .sides = side_number(surface.boundary.x) + 4 * side_number(surface.boundary.y),
            .climb_x = static_cast<float>(surface.tilt.x * surface.grid.width_m()),
            .climb_y = static_cast<float>(surface.tilt.y * surface.grid.height_m()),
            .half_width_x = frame.half_width_x,
            .half_width_y = frame.half_width_y,
            .first_column = frame.columns.first,
            .column_count = frame.columns.count,
            .first_row = frame.rows.first,
            .row_count = frame.rows.count,
            .half_samples = frame.half_samples(),
            .half_channels = frame.half_channels(),
            .map_width = frame.map_width,
            .map_height = frame.map_height,
            .options = (frame.count_base_x ? 1 : 0) + (frame.count_base_y ? 2 : 0) + (frame.adaptive ? 4 : 0) +
                       8 * frame.strips,
            .band_begin = 0,
            .band_count = 0};
}

/// What pass 0 stores of a sample.
std::int64_t landed_values(const FloorFrame& frame) { return frame.adaptive ? 7 : 3; }

/// How many lattice rows the passes handle at a time.
int band_rows(const FloorFrame& frame) {
    const std::int64_t channels = std::int64_t{frame.map_width} * frame.window.channels;
    const std::int64_t landed = std::int64_t{frame.columns.count} * landed_values(frame);
    const auto row_bytes = static_cast<std::int64_t>(sizeof(float)) * std::max(channels, landed);
    if (row_bytes > band_bytes)
        throw InputError(
            fmt::format("floor map: one row of {} pixels with a window of {} x {} takes {} bytes; allowed on the "
                        "vulkan back-end: {}. Give a smaller window or fewer, larger pixels",
                        frame.map_width, frame.window.samples, frame.window.channels, row_bytes, band_bytes));
    return static_cast<int>(std::min<std::int64_t>(frame.rows.count, band_bytes / row_bytes));
}

class FloorVulkan final : public FloorMapper {
  public:
    FloorVulkan(const FloorSettings& settings, std::shared_ptr<gpu::Context> context)
        : settings_(settings),
          shaded_(settings.objects && !settings.objects->empty()),
          find_shadows_(settings),
          context_(std::move(context)),
          commands_(context_) {
        const std::vector<gpu::Texels> numbers{gpu::Texels::r32f}, surface(3, gpu::Texels::r32f);
        const auto pass = [&](const char* name, std::span<const std::uint32_t> spirv, std::uint32_t buffers,
                              std::array<std::uint32_t, 3> workgroup, const std::vector<gpu::Texels>& texels) {
            return gpu::Pass(context_, {name, spirv, buffers, sizeof(FloorParameters), workgroup, texels});
        };
        land_ = shaded_ ? pass("floor: land shaded", shaders::floor_land_shaded, 4, row_workgroup, surface)
                        : pass("floor: land", shaders::floor_land, 3, row_workgroup, surface);
        gather_ = settings.footprint == Footprint::adaptive
                      ? pass("floor: gather adaptive", shaders::floor_gather_adaptive, 1, tile_workgroup, numbers)
                      : pass("floor: gather", shaders::floor_gather, 1, tile_workgroup, numbers);
        sum_ = pass("floor: sum", shaders::floor_sum, 1, tile_workgroup, numbers);
    }

    std::string_view backend() const override { return "vulkan"; }

    void compute(const Surface& surface, FloorMap& map) override {
        const FloorFrame frame = prepare(settings_, surface);
        const int rows = band_rows(frame);
        allocate(frame, surface, rows);
        write(frame, surface);
        record(frame, surface, rows);
        commands_.run();
        read(frame, map);
    }

  private:
    using Storage = std::optional<gpu::Buffer>;

    /// Gives `buffer` room for `count` values of T, at least one.
    template <class T>
    void reserve(Storage& buffer, std::int64_t count, BufferUse use) {
        const std::size_t bytes = sizeof(T) * static_cast<std::size_t>(std::max<std::int64_t>(count, 1));
        if (!buffer || buffer->bytes() < bytes) buffer.emplace(context_, bytes, use);
    }

    void allocate(const FloorFrame& frame, const Surface& surface, int rows) {
        const std::int64_t columns = frame.columns.count, width = frame.map_width;
        const auto cells = static_cast<std::int64_t>(surface.grid.cells());
        reserve<FloorPlace>(places_, columns + frame.rows.count, BufferUse::from_host);
        reserve<float>(elevation_, cells, BufferUse::from_host);
        reserve<float>(slope_x_, cells, BufferUse::from_host);
        reserve<float>(slope_y_, cells, BufferUse::from_host);
        reserve<float>(landed_, landed_values(frame) * columns * rows, BufferUse::device);
        reserve<FloorRowLedger>(ledger_, std::int64_t{frame.rows.count} * row_workgroup[0], BufferUse::to_host);
        reserve<float>(channels_, width * rows * frame.window.channels, BufferUse::device);
        reserve<float>(map_, width * frame.map_height, BufferUse::to_host);
        if (shaded_) {
            reserve<float>(shadows_, 3 * columns * frame.rows.count, BufferUse::from_host);
            land_->bind({&*places_, &*landed_, &*ledger_, &*shadows_}, {&*elevation_, &*slope_x_, &*slope_y_});
        } else {
            land_->bind({&*places_, &*landed_, &*ledger_}, {&*elevation_, &*slope_x_, &*slope_y_});
        }
        gather_->bind({&*channels_}, {&*landed_});
        sum_->bind({&*map_}, {&*channels_});
    }

    void write(const FloorFrame& frame, const Surface& surface) {
        FloorPlace* place = places_->host<FloorPlace>().data();
        const auto put = [&](SplitPlace x, SplitPlace y) { *place++ = {x.whole, x.part, y.whole, y.part}; };
        for (int i = 0; i < frame.columns.count; ++i) put(frame.column_x[i], frame.column_y[i]);
        for (int j = 0; j < frame.rows.count; ++j) put(frame.row_x[j], frame.row_y[j]);
        std::ranges::copy(surface.elevation.values(), elevation_->host<float>().begin());
        std::ranges::copy(surface.slope_x.values(), slope_x_->host<float>().begin());
        std::ranges::copy(surface.slope_y.values(), slope_y_->host<float>().begin());
        if (shaded_) write_shadows(frame, surface);
    }

    /// Found on the CPU: three numbers a sample.
    void write_shadows(const FloorFrame& frame, const Surface& surface) {
        const ShadowRows rows = find_shadows_.cast(surface, frame);
        const std::span<float> to = shadows_->host<float>();
        std::ranges::fill(to, 0.0F);
        for (int j = 0; j < frame.rows.count; ++j)
            for (const ShadowedSample& s : rows.row(j)) {
                float* at = to.data() + 3 * (static_cast<std::ptrdiff_t>(j) * frame.columns.count + s.column);
                at[0] = static_cast<float>(s.shadow.above);
                at[1] = static_cast<float>(s.shadow.below);
                at[2] = static_cast<float>(s.shadow.stopped);
            }
    }

    void record(const FloorFrame& frame, const Surface& surface, int rows) {
        for (const Storage* from_host : {&places_, &elevation_, &slope_x_, &slope_y_}) commands_.upload(**from_host);
        if (shaded_) commands_.upload(*shadows_);
        commands_.clear(*map_);
        FloorParameters push = parameters(frame, surface);
        for (int begin = 0; begin < frame.rows.count; begin += rows) {
            push.band_begin = begin;
            push.band_count = std::min(rows, frame.rows.count - begin);
            const auto width = static_cast<std::uint32_t>(frame.map_width);
            const auto count = static_cast<std::uint32_t>(push.band_count);
            const auto reached = static_cast<std::uint32_t>(push.band_count + frame.window.channels - 1);
            commands_.dispatch(*land_, {row_workgroup[0], count, 1}, push);
            commands_.dispatch(*gather_, {width, count, 1}, push);
            commands_.dispatch(*sum_, {width, reached, 1}, push);
        }
        commands_.download(*map_);
        commands_.download(*ledger_);
    }

    void read(const FloorFrame& frame, FloorMap& map) const {
        if (map.irradiance.nx() != frame.map_width || map.irradiance.ny() != frame.map_height)
            map.irradiance = Field<float>(frame.map_width, frame.map_height);
        map.window = frame.window;
        map.ledger = {};
        const double area = frame.pixel_area_m2;
        const std::size_t parts = std::size_t{row_workgroup[0]} * static_cast<std::size_t>(frame.rows.count);
        for (const FloorRowLedger& part : ledger_->host<FloorRowLedger>().first(parts)) {
            map.ledger.incident_w += area * part.incident;
            map.ledger.reflected_w += area * part.reflected;
            map.ledger.extinguished_w += area * part.extinguished;
            map.ledger.outside_w += area * part.outside;
            map.ledger.lost_w += area * part.lost;
            map.ledger.entered_w += area * part.entered;
            map.ledger.objects_w += area * part.objects;
        }
        double sum = 0;
        const std::span<const float> pixels = map_->host<float>().first(map.irradiance.size());
        std::ranges::copy(pixels, map.irradiance.data());
        for (const float irradiance : pixels) sum += irradiance;
        map.ledger.floor_w = area * sum;
    }

    FloorSettings settings_;
    bool shaded_;  ///< there are objects
    ObjectShadows find_shadows_;
    std::shared_ptr<gpu::Context> context_;
    std::optional<gpu::Pass> land_, gather_, sum_;
    Storage places_, elevation_, slope_x_, slope_y_, landed_, ledger_, channels_, map_, shadows_;
    gpu::Commands commands_;
};

}  // namespace

std::unique_ptr<FloorMapper> make_floor_vulkan(const FloorSettings& settings, std::shared_ptr<gpu::Context> context) {
    validate(settings);
    if (settings.samples_per_pixel == 1) return std::make_unique<FloorVulkan>(settings, std::move(context));
    return average_samples(settings, make_floor_vulkan(one_sample_a_pixel(settings), std::move(context)));
}

}  // namespace waterlight
