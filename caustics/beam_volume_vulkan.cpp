#include "caustics/beam_volume_vulkan.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>

#include "caustics/beam_buffers.hpp"
#include "gpu/commands.hpp"
#include "gpu/pass.hpp"
#include "shaders/beam_fields.hpp"

namespace waterlight {

namespace {

#include "caustics/shaders/beam_field_parameters.glsl"

using gpu::BufferUse;

constexpr std::array<std::uint32_t, 3> workgroup{64, 1, 1};
constexpr std::uint32_t slices_each = 8;                  // that an invocation handles, as in the shader
constexpr std::size_t band_bytes = std::size_t{1} << 26;  // of sums
constexpr double whole_flux = static_cast<double>(std::uint64_t{1} << 44);  // in quanta

/// A number of 64 bits as the device holds it.
struct Quanta {
    std::uint32_t low, high;
    double value() const { return static_cast<double>(std::uint64_t{high} << 32 | low); }
};
struct CellSums {
    Quanta plane, scalar;
};
struct RowLedger {
    Quanta flux, outside;
};

BeamFieldParameters parameters(const Beams& b, glm::ivec3 cells, double quantum_w) {
    const Grid& g = b.domain;
    return {.nx = b.nx,
            .ny = b.ny,
            .columns = cells.x,
            .rows = cells.y,
            .slices = cells.z,
            .first_slice = 0,
            .slice_count = 0,
            .periodic_x = b.boundary.x == Side::periodic ? 1 : 0,
            .periodic_y = b.boundary.y == Side::periodic ? 1 : 0,
            .x0 = static_cast<float>(g.x0_m),
            .y0 = static_cast<float>(g.y0_m),
            .per_metre_x = static_cast<float>(cells.x / g.width_m()),
            .per_metre_y = static_cast<float>(cells.y / g.height_m()),
            .depth = static_cast<float>(b.depth_m),
            .extinction = static_cast<float>(b.extinction_per_m),
            .per_quantum = static_cast<float>(1 / quantum_w)};
}

/// By the host's clock: lavapipe stamps a pass before it is done.
template <class Work>
void timed(double& seconds, Work work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double total(const Field<float>& flux) {
    double sum = 0;
    for (const float f : flux.values()) sum += f;
    return sum;
}

}  // namespace

struct BeamVolumeVulkan::Impl {
    std::shared_ptr<gpu::Context> context;
    gpu::Pass share;
    BeamBuffers beams;
    Storage sums;
    gpu::Commands commands;
    std::vector<StageTime> times;

    explicit Impl(std::shared_ptr<gpu::Context> owner)
        : context(std::move(owner)),
          share(context, {"fields", shaders::beam_fields, 3, sizeof(BeamFieldParameters), workgroup}),
          commands(context) {}

    void fill(const Beams& b, glm::ivec3 cells, BeamVolume& volume) {
        waterlight::fit(b, cells, volume);
        times = {{"share", 0}, {"read", 0}};
        const double flux_w = total(b.flux);
        if (!(flux_w > 0)) return darken(volume);
        BeamFieldParameters push = parameters(b, cells, flux_w / whole_flux);
        const std::size_t slice_bytes = sizeof(CellSums) * static_cast<std::size_t>(cells.x) * cells.y;
        const int band = static_cast<int>(std::clamp<std::size_t>(band_bytes / slice_bytes, 1, cells.z));
        reserve(context, sums, (slice_bytes + sizeof(RowLedger) * b.ny) * band, BufferUse::to_host);
        for (push.first_slice = 0; push.first_slice < cells.z; push.first_slice += band) {
            push.slice_count = std::min(band, cells.z - push.first_slice);
            timed(times[0].seconds, [&] { run(b, push); });
            timed(times[1].seconds, [&] { read(b, push, flux_w / whole_flux, volume); });
        }
    }

    static void darken(BeamVolume& volume) {
        volume.plane_irradiance.fill(0);
        volume.scalar_irradiance.fill(0);
    }

    void run(const Beams& b, const BeamFieldParameters& push) {
        beams.write(context, b, commands);
        share.bind({&*beams.corners, &*beams.flux, &*sums});
        commands.clear(*sums);
        const auto groups = (static_cast<std::uint32_t>(push.slice_count) + slices_each - 1) / slices_each;
        commands.dispatch(share, {2 * static_cast<std::uint32_t>(b.nx), static_cast<std::uint32_t>(b.ny), groups},
                          push);
        commands.download(*sums);
        commands.run();
    }

    void read(const Beams& b, const BeamFieldParameters& push, double quantum_w, BeamVolume& volume) const {
        const std::size_t size = static_cast<std::size_t>(push.columns) * push.rows;
        const double per_area = quantum_w * static_cast<double>(size) / (b.domain.width_m() * b.domain.height_m());
        const CellSums* all = sums->host<CellSums>().data();
        const auto* rows = reinterpret_cast<const RowLedger*>(all + push.slice_count * size);
#pragma omp parallel for schedule(static)
        for (int k = 0; k < push.slice_count; ++k) {
            const std::size_t slice = push.first_slice + k;
            const CellSums* from = all + k * size;
            float *plane = volume.plane_irradiance.data() + slice * size,
                  *scalar = volume.scalar_irradiance.data() + slice * size;
            SliceLedger& l = volume.ledger[slice];
            double inside = 0, flux = 0, outside = 0;
            for (std::size_t i = 0; i < size; ++i) {
                const double through = from[i].plane.value();
                inside += through;
                plane[i] = static_cast<float>(through * per_area);
                scalar[i] = static_cast<float>(from[i].scalar.value() * per_area);
            }
            for (int j = 0; j < b.ny; ++j) {
                flux += rows[k * b.ny + j].flux.value();
                outside += rows[k * b.ny + j].outside.value();
            }
            l.flux_w = flux * quantum_w;
            l.inside_w = inside * quantum_w;
            l.outside_w = outside * quantum_w;
        }
    }
};

BeamVolumeVulkan::BeamVolumeVulkan(std::shared_ptr<gpu::Context> context)
    : impl_(std::make_unique<Impl>(std::move(context))) {}

BeamVolumeVulkan::~BeamVolumeVulkan() = default;

void BeamVolumeVulkan::fill(const Beams& beams, glm::ivec3 cells, BeamVolume& volume) {
    impl_->fill(beams, cells, volume);
    if (!beams.pieces) return;
    const std::vector<StageTime> of_whole = impl_->times;
    BeamVolume more;
    impl_->fill(beams.pieces->beams, cells, more);
    add(more, volume);
    for (std::size_t k = 0; k < of_whole.size(); ++k) impl_->times[k].seconds += of_whole[k].seconds;
}

const std::vector<StageTime>& BeamVolumeVulkan::stage_times() const { return impl_->times; }

}  // namespace waterlight
