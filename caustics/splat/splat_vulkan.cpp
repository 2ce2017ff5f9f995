// Caustics mapping on a Vulkan device: vertices enter and land in one pass, are given their splats in another, and are
// drawn into the map, added as the paper's points are.
#include "caustics/splat/splat_vulkan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "caustics/beam_buffers.hpp"
#include "caustics/kernels/surface_lookup.hpp"
#include "caustics/splat/capture.hpp"
#include "caustics/splat/splat_map.hpp"
#include "gpu/pass.hpp"
#include "gpu/raster.hpp"
#include "shaders/splat_box.hpp"
#include "shaders/splat_flights.hpp"
#include "shaders/splat_light.hpp"
#include "shaders/splat_shape.hpp"
#include "shaders/splat_water.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

#include "caustics/splat/shaders/splat_parameters.glsl"

using gpu::BufferUse;

constexpr std::array<std::uint32_t, 3> workgroup{64, 1, 1};
constexpr std::int64_t most_vertices = std::int64_t{1} << 23;

/// A place on the map: whole pixels, and a part that floats keep exact.
struct SplitPixel {
    glm::ivec2 whole{0, 0};
    glm::vec2 part{0, 0};
    explicit SplitPixel(glm::dvec2 at) : whole(glm::floor(at)), part(at - glm::floor(at)) {}
};

SplatParameters parameters(const SplatSettings& s, const SplatFrame& f, const Surface& surface, const Receivers& r) {
    const auto real = [](double x) { return static_cast<float>(x); };
    const Grid &g = surface.grid, &texels = r.texels();
    const VertexLattice& l = f.lattice;
    const f64::SplatLight& light = f.light;
    const glm::dvec2 step_x = f.to_pixels * glm::dvec2{l.spacing_m.x, 0},
                     step_y = f.to_pixels * glm::dvec2{0, l.spacing_m.y};
    return {.source_x = real(light.image.source.x),
            .source_y = real(light.image.source.y),
            .source_z = real(light.image.source.z),
            .parallel = real(light.image.parallel),
            .level = real(light.image.level),
            .strength = real(light.strength),
            .axis_x = real(light.axis.x),
            .axis_y = real(light.axis.y),
            .axis_z = real(light.axis.z),
            .cosine = real(light.cosine),
            .index = real(f.index),
            .fresnel = real(f.fresnel),
            .extinction = real(f.extinction_per_m),
            .nx = g.nx,
            .ny = g.ny,
            .sides = side_number(surface.boundary.x) + 4 * side_number(surface.boundary.y),
            .climb_x = real(surface.tilt.x * g.width_m()),
            .climb_y = real(surface.tilt.y * g.height_m()),
            .half_width_x = real(0.5 * l.spacing_m.x / g.dx_m),
            .half_width_y = real(0.5 * l.spacing_m.y / g.dy_m),
            .list = 0,
            .count = l.count.x * l.count.y,
            .columns = l.count.x,
            .rows = l.count.y,
            .first_x = l.first.x,
            .first_y = l.first.y,
            .domain_x = l.domain.x,
            .domain_y = l.domain.y,
            .rim = vertex_rim,
            .ends = (f.ends.x ? 1 : 0) + (f.ends.y ? 2 : 0),
            .area = real(l.area_m2()),
            .step_x_x = real(step_x.x),
            .step_x_y = real(step_x.y),
            .step_y_x = real(step_y.x),
            .step_y_y = real(step_y.y),
            .iterations = s.options.iterations,
            .by_height = s.options.landing == SplatOptions::Landing::height,
            .pixel_m = real(f.pixel_m),
            .texels_x = r.level() ? 0 : texels.nx,
            .texels_y = texels.ny,
            .texel_sides = side_number(r.boundary().x) + 4 * side_number(r.boundary().y),
            .texel_at_x = real(texels.x_m(0)),
            .texel_at_y = real(texels.y_m(0)),
            .texel_width = real(texels.dx_m),
            .texel_height = real(texels.dy_m),
            .pixel_x_x = real(f.to_pixels[0].x),
            .pixel_x_y = real(f.to_pixels[1].x),
            .pixel_y_x = real(f.to_pixels[0].y),
            .pixel_y_y = real(f.to_pixels[1].y),
            .map_width = f.plan.width,
            .map_height = f.plan.height,
            .fixed_size = s.options.size == SplatOptions::Size::fixed,
            .radius = real(s.options.radius_pixels),
            .wraps = 0,
            .period_x_x = 0,
            .period_x_y = 0,
            .period_y_x = 0,
            .period_y_y = 0,
            .per_x_x = 0,
            .per_x_y = 0,
            .per_y_x = 0,
            .per_y_y = 0,
            .origin_x = 0,
            .origin_y = 0,
            .copy_low_x = 0,
            .copy_high_x = 0,
            .copy_low_y = 0,
            .copy_high_y = 0};
}

/// What lands repeats: it is brought into the domain, and copied from there as often as the map, and splats up to a
/// period wide, ask for.
void add_periods(const SplatFrame& f, SplatParameters& p) {
    const BoxM map = box_about(f.plan);
    const glm::dvec2 x = f.to_pixels * glm::dvec2{f.period_m.x, 0}, y = f.to_pixels * glm::dvec2{0, f.period_m.y};
    p.period_x_x = static_cast<float>(x.x);
    p.period_x_y = static_cast<float>(x.y);
    p.period_y_x = static_cast<float>(y.x);
    p.period_y_y = static_cast<float>(y.y);
    const glm::dmat2 to_metres = glm::inverse(f.to_pixels);
    const auto axis = [&](int n, int bit, float& per_x, float& per_y, float& origin, int& low, int& high) {
        const double period = f.period_m[n], corner = f.lattice.corner_m[n];
        if (period == 0) return;
        p.wraps += bit;
        per_x = static_cast<float>(to_metres[0][n] / period);
        per_y = static_cast<float>(to_metres[1][n] / period);
        origin = static_cast<float>((f.plan.origin_m[n] - corner) / period);
        constexpr double rounding = 1e-9;
        low = static_cast<int>(std::floor((map.first[n] - corner) / period + rounding)) - 1;
        high = static_cast<int>(std::ceil((map.second[n] - corner) / period - rounding));
    };
    axis(0, 1, p.per_x_x, p.per_x_y, p.origin_x, p.copy_low_x, p.copy_high_x);
    axis(1, 2, p.per_y_x, p.per_y_y, p.origin_y, p.copy_low_y, p.copy_high_y);
}

void add(const SplatAccount& part, FlightAccount& sum) {
    sum.ledger.incident_w += part.incident;
    sum.ledger.reflected_w += part.reflected;
    sum.ledger.extinguished_w += part.extinguished;
    sum.ledger.outside_w += part.outside;
    sum.ledger.lost_w += part.lost;
    sum.ledger.entered_w += part.entered;
    sum.report.vertices += part.vertices;
    sum.report.not_converged += part.not_converged;
    sum.report.missed += part.missed;
    sum.step2_m2 += part.step2;
}

class SplatVulkan final : public SplatFloor {
  public:
    SplatVulkan(const SplatSettings& settings, std::shared_ptr<gpu::Context> context)
        : s_(settings),
          context_(std::move(context)),
          water_(context_, {"splat: water", shaders::splat_water, 8, 0, workgroup}),
          flights_pass_(context_, {"splat: flights", shaders::splat_flights, 5, 0, workgroup}),
          shape_(context_, {"splat: shape", shaders::splat_shape, 5, 0, workgroup}),
          draw_(context_, {"splat: draw", shaders::splat_box, shaders::splat_light, 1, sizeof(SplatShift)}),
          commands_(context_) {
        validate(s_);
    }

    std::string_view backend() const override { return "vulkan"; }
    SplatReport report() const override { return report_; }

    void compute(const Surface& surface, FloorMap& map) override {
        SplatFrame frame = splat_frame(s_, surface);
        const Receivers receivers = receivers_of(s_, frame, surface);
        FlightAccount account;
        SplatParameters p{};
        if (water_alone(s_)) {
            widen_to_water(s_, frame, surface);
            p = parameters(s_, frame, surface, receivers);
            check(p.count);
            write_water(frame, surface);
        } else {
            const CapturedLight light = capture(s_, frame, surface);
            p = parameters(s_, frame, surface, receivers);
            p.list = 1;
            check(static_cast<std::int64_t>(light.all.size()));
            p.count = static_cast<int>(light.all.size());
            write_flights(frame, light);
            account = light.account;
        }
        add_periods(frame, p);
        run(p, receivers);
        read(p, account);
        map.ledger = account.ledger;
        report_ = account.summed_report();
        write_map(s_, frame, receivers, pixels_->host<float>().data(), map);
    }

  private:
    static void check(std::int64_t vertices) {
        if (vertices > most_vertices)
            throw InputError(
                fmt::format("splats: {} vertices; allowed on the vulkan back-end: at most 2^23. Give a smaller "
                            "grid, or the cpu back-end",
                            vertices));
    }

    static std::size_t chunks(const SplatParameters& p) {
        return static_cast<std::size_t>(std::max(1, (p.count + splat_chunk - 1) / splat_chunk));
    }

    void write_water(const SplatFrame& frame, const Surface& surface) {
        const VertexLattice& l = frame.lattice;
        const FloorFrame rows = vertex_rows(l, surface.grid, surface.boundary);
        reserve(context_, places_, sizeof(SplatPlace) * static_cast<std::size_t>(l.count.x + l.count.y),
                BufferUse::from_host);
        SplatPlace* place = places_->host<SplatPlace>().data();
        const auto put = [&](SplitPlace cell, double at, glm::dvec2 pixel) {
            const SplitPixel split(pixel);
            *place++ = {cell.whole,    cell.part,   static_cast<float>(at), split.whole.x, split.part.x,
                        split.whole.y, split.part.y};
        };
        const glm::dvec2 origin = frame.plan.pixel({0, 0});
        for (int i = 0; i < l.count.x; ++i) {
            const double at = l.place_m(l.first + glm::ivec2{i, 0}).x;
            put(rows.column_x[static_cast<std::size_t>(i)], at, origin + frame.to_pixels * glm::dvec2{at, 0});
        }
        for (int j = 0; j < l.count.y; ++j) {
            const double at = l.place_m(l.first + glm::ivec2{0, j}).y;
            put(rows.row_y[static_cast<std::size_t>(j)], at, frame.to_pixels * glm::dvec2{0, at});
        }
        commands_.upload(*places_);
        write(context_, elevation_, {surface.elevation.values()}, commands_);
        write(context_, slope_x_, {surface.slope_x.values()}, commands_);
        write(context_, slope_y_, {surface.slope_y.values()}, commands_);
        reserve(context_, flights_, sizeof(SplatFlight), BufferUse::from_host);
    }

    void write_flights(const SplatFrame& frame, const CapturedLight& light) {
        reserve(context_, flights_, sizeof(SplatFlight) * std::max<std::size_t>(1, light.all.size()),
                BufferUse::from_host);
        SplatFlight* to = flights_->host<SplatFlight>().data();
        for (std::size_t k = 0; k < light.all.size(); ++k) {
            const CapturedVertex& v = light.all[k];
            const glm::vec3 start(v.flight.start_m), way(v.flight.direction);
            const SplitPixel pixel(frame.plan.pixel(glm::dvec2(v.flight.start_m)));
            const glm::ivec4 n = light.neighbours[k];
            *to++ = {start.x,
                     start.y,
                     start.z,
                     way.x,
                     way.y,
                     way.z,
                     static_cast<float>(v.flight.power_w),
                     static_cast<float>(v.flight.extinction_per_m),
                     v.flight.own,
                     pixel.whole.x,
                     pixel.part.x,
                     pixel.whole.y,
                     pixel.part.y,
                     v.vertex.x,
                     v.vertex.y,
                     n[0],
                     n[1],
                     n[2],
                     n[3]};
        }
        commands_.upload(*flights_);
    }

    void run(const SplatParameters& p, const Receivers& receivers) {
        const auto count = static_cast<std::size_t>(std::max(1, p.count));
        const std::size_t parts = std::size_t{workgroup[0]} * chunks(p);
        reserve(context_, parameters_, sizeof(SplatParameters), BufferUse::from_host);
        parameters_->host<SplatParameters>()[0] = p;
        commands_.upload(*parameters_);
        write(context_, heights_, {receivers.heights_m().values()}, commands_);
        reserve(context_, landings_, sizeof(SplatLanding) * count, BufferUse::device);
        reserve(context_, records_, sizeof(SplatRecord) * count, BufferUse::device);
        reserve(context_, landed_, sizeof(SplatAccount) * parts, BufferUse::to_host);
        reserve(context_, laid_, sizeof(SplatAccount) * parts, BufferUse::to_host);
        const gpu::Extent all{workgroup[0], static_cast<std::uint32_t>(chunks(p)), 1};
        if (p.list != 0) {
            flights_pass_.bind({&*parameters_, &*flights_, &*heights_, &*landings_, &*landed_});
            commands_.dispatch(flights_pass_, all);
        } else {
            water_.bind(
                {&*parameters_, &*places_, &*elevation_, &*slope_x_, &*slope_y_, &*heights_, &*landings_, &*landed_});
            commands_.dispatch(water_, all);
        }
        shape_.bind({&*parameters_, &*flights_, &*landings_, &*records_, &*laid_});
        commands_.dispatch(shape_, all);
        draw(p);
        commands_.download(*landed_);
        commands_.download(*laid_);
        commands_.download(*pixels_);
        commands_.run();
    }

    void draw(const SplatParameters& p) {
        const auto width = static_cast<std::uint32_t>(p.map_width), height = static_cast<std::uint32_t>(p.map_height);
        if (!target_ || target_->width() != width || target_->height() != height)
            target_.emplace(context_, width, height);
        reserve(context_, pixels_, sizeof(float) * width * height, BufferUse::to_host);
        draw_.bind({&*records_});
        commands_.clear(*target_);
        for (int b = p.copy_low_y; b <= p.copy_high_y; ++b)
            for (int a = p.copy_low_x; a <= p.copy_high_x; ++a) {
                const auto x = static_cast<float>(a), y = static_cast<float>(b);
                commands_.draw(draw_, *target_, {static_cast<std::uint32_t>(p.count), 4},
                               SplatShift{x * p.period_x_x + y * p.period_y_x, x * p.period_x_y + y * p.period_y_y,
                                          static_cast<float>(p.map_width), static_cast<float>(p.map_height)});
            }
        commands_.copy(*target_, *pixels_);
    }

    void read(const SplatParameters& p, FlightAccount& account) const {
        const std::size_t parts = std::size_t{workgroup[0]} * chunks(p);
        for (const Storage* storage : {&landed_, &laid_})
            for (const SplatAccount& part : (*storage)->host<SplatAccount>().first(parts)) add(part, account);
    }

    SplatSettings s_;
    SplatReport report_;
    std::shared_ptr<gpu::Context> context_;
    gpu::Pass water_, flights_pass_, shape_;
    gpu::Raster draw_;
    std::optional<gpu::Target> target_;
    Storage parameters_, places_, elevation_, slope_x_, slope_y_, heights_, flights_, landings_, records_, landed_,
        laid_, pixels_;
    gpu::Commands commands_;
};

}  // namespace

std::unique_ptr<SplatFloor> make_splat_floor_vulkan(const SplatSettings& settings,
                                                    std::shared_ptr<gpu::Context> context) {
    return std::make_unique<SplatVulkan>(settings, std::move(context));
}

}  // namespace waterlight
