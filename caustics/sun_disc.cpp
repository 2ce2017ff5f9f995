#include "caustics/sun_disc.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "caustics/floor_frame.hpp"
#include "caustics/kernels/sun_disc.hpp"
#include "sim/error.hpp"

namespace waterlight {

Spread disc_spread(const FloorSettings& settings, double half_angle_deg) {
    const double radian = std::numbers::pi / 180;
    const double elevation = std::max(0.0, settings.sun.elevation_deg) * radian;
    const glm::dvec2 axes = f64::disc_axes(std::sin(elevation), settings.optics.refractive_index);
    const glm::dvec2 metres = settings.depth_m * half_angle_deg * radian * axes;
    const double azimuth = (settings.sun.azimuth_deg - settings.plan.angle_deg) * radian;
    const double c = std::cos(azimuth), s = std::sin(azimuth);
    const double along = 0.25 * metres.x * metres.x, across = 0.25 * metres.y * metres.y;
    const glm::dvec2 pitch = settings.plan.pitch_m;
    return {(along * c * c + across * s * s) / (pitch.x * pitch.x), (along - across) * c * s / (pitch.x * pitch.y),
            (along * s * s + across * c * c) / (pitch.y * pitch.y)};
}

namespace {

/// Whether a map of `count` pixels from `origin` is one period of a side.
bool is_period(Side side, double origin, double length, double from, double extent) {
    const double slack = 1e-9 * extent;
    return side == Side::periodic && std::abs(origin - from) <= slack && std::abs(length - extent) <= slack;
}

class SunDisc final : public FloorMapper {
  public:
    SunDisc(const FloorSettings& settings, double half_angle_deg, FloorMaker make)
        : settings_(settings), make_(std::move(make)), taps_(disc_spread(settings, half_angle_deg)) {
        enlarge({false, false});
    }

    std::string_view backend() const override { return parallel_->backend(); }

    void compute(const Surface& surface, FloorMap& map) override {
        const FloorPlan& plan = settings_.plan;
        const Grid& g = surface.grid;
        const bool straight = plan.angle_deg == 0;
        const glm::bvec2 wraps{straight && is_period(surface.boundary.x, plan.origin_m.x, plan.width * plan.pitch_m.x,
                                                     g.x0_m, g.width_m()),
                               straight && is_period(surface.boundary.y, plan.origin_m.y, plan.height * plan.pitch_m.y,
                                                     g.y0_m, g.height_m())};
        if (wraps != wraps_) enlarge(wraps);
        parallel_->compute(surface, sharp_);
        if (map.irradiance.nx() != plan.width || map.irradiance.ny() != plan.height)
            map.irradiance = Field<float>(plan.width, plan.height);
        convolve(taps_, with_repeats(), map.irradiance);
        map.window = sharp_.window;
        settle(map);
    }

  private:
    /// The mapper of parallel light on the plan with its margin.
    void enlarge(glm::bvec2 wraps) {
        FloorSettings settings = settings_;
        const glm::ivec2 margin{wraps.x ? 0 : taps_.reach().x, wraps.y ? 0 : taps_.reach().y};
        settings.plan.origin_m = settings_.plan.position_m(-glm::dvec2(margin));
        settings.plan.width += 2 * margin.x;
        settings.plan.height += 2 * margin.y;
        parallel_ = make_(settings);
        wraps_ = wraps;
    }

    /// The sharp map, with its own other side along sides that wrap.
    const Field<float>& with_repeats() {
        if (!wraps_.x && !wraps_.y) return sharp_.irradiance;
        const Field<float>& sharp = sharp_.irradiance;
        const int width = settings_.plan.width, height = settings_.plan.height;
        const glm::ivec2 reach = taps_.reach(), by{wraps_.x ? reach.x : 0, wraps_.y ? reach.y : 0};
        if (repeated_.empty()) repeated_ = Field<float>(width + 2 * reach.x, height + 2 * reach.y);
        const auto wrapped = [](int i, int n) { return ((i % n) + n) % n; };
        for (int j = 0; j < repeated_.ny(); ++j) {
            const float* from = sharp.row(wrapped(j - by.y, sharp.ny()));
            float* to = repeated_.row(j);
            std::copy_n(from, sharp.nx(), to + by.x);
            for (int i = 0; i < by.x; ++i) {
                to[i] = from[wrapped(i - by.x, sharp.nx())];
                to[by.x + sharp.nx() + i] = from[wrapped(i, sharp.nx())];
            }
        }
        return repeated_;
    }

    /// The ledger: what the disc carries off the map is outside.
    void settle(FloorMap& map) const {
        double sum = 0;
        for (const float e : map.irradiance.values()) sum += e;
        map.ledger = sharp_.ledger;
        map.ledger.floor_w = sum * settings_.plan.pitch_m.x * settings_.plan.pitch_m.y;
        map.ledger.outside_w += sharp_.ledger.floor_w - map.ledger.floor_w;
    }

    FloorSettings settings_;
    FloorMaker make_;
    EllipseTaps taps_;
    std::unique_ptr<FloorMapper> parallel_;
    glm::bvec2 wraps_{false, false};
    FloorMap sharp_;
    Field<float> repeated_;
};

}  // namespace

std::unique_ptr<FloorMapper> make_sun_disc(const FloorSettings& settings, double half_angle_deg, FloorMaker make) {
    validate(settings);
    constexpr double most = 10;
    if (!(half_angle_deg > 0 && half_angle_deg <= most))
        throw InputError(fmt::format("floor map: half-angle of the sun's disc in degrees is {}; allowed: in (0, {}]",
                                     half_angle_deg, most));
    return std::make_unique<SunDisc>(settings, half_angle_deg, std::move(make));
}

}  // namespace waterlight
