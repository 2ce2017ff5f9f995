#include "caustics/photons/photons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "caustics/photons/blur.hpp"
#include "caustics/photons/open_water.hpp"
#include "caustics/photons/photon_pass.hpp"
#include "caustics/photons/photon_settings.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

/// Deposits on the pixels of the map.
class MapReceiver {
  public:
    MapReceiver(const PhotonSettings& settings, const Surface& surface)
        : plan_(settings.floor.plan),
          to_x_(plan_.axis_x() / plan_.pitch_m.x),
          to_y_(plan_.axis_y() / plan_.pitch_m.y),
          per_ground_area_(settings.per_ground_area) {
        const PhotonDomain domain(surface);
        const auto [first, last] = periods(domain);
        for (int j = first.y; j <= last.y; ++j)
            for (int i = first.x; i <= last.x; ++i)
                repeats_.push_back(glm::dvec2(i, j) * domain.size_m - plan_.origin_m);
    }

    void operator()(std::span<const PhotonLanding> landings, std::vector<PhotonDeposit>& deposits,
                    FloorLedger& ledger) const {
        for (const PhotonLanding& landing : landings) {
            if (landing.object >= 0) continue;
            const std::size_t before = deposits.size();
            for (const glm::dvec2 repeat : repeats_) deposit(landing, glm::dvec2(landing.at_m) + repeat, deposits);
            const double shown_w = static_cast<double>(deposits.size() - before) * landing.power_w;
            ledger.floor_w += shown_w;
            if (landing.own && shown_w == 0) ledger.outside_w += landing.power_w;
            ledger.entered_w += landing.own ? std::max(0.0, shown_w - landing.power_w) : shown_w;
        }
    }

  private:
    /// Of the periodic sides' repetitions, those that reach the map.
    std::pair<glm::ivec2, glm::ivec2> periods(const PhotonDomain& domain) const {
        glm::dvec2 low = plan_.position_m({0, 0}), high = low;
        for (const glm::dvec2 corner : {glm::dvec2{plan_.width, 0}, {0, plan_.height}, {plan_.width, plan_.height}}) {
            low = glm::min(low, plan_.position_m(corner));
            high = glm::max(high, plan_.position_m(corner));
        }
        constexpr double slack = 1e-9;  // a map that ends where the domain does shows one
        glm::ivec2 first{0, 0}, last{0, 0};
        for (int axis = 0; axis < 2; ++axis) {
            if (!domain.periodic(axis)) continue;
            const double size = domain.size_m[axis], from = domain.low_m[axis];
            first[axis] = static_cast<int>(std::floor((low[axis] - from) / size + slack));
            last[axis] = static_cast<int>(std::ceil((high[axis] - from) / size - slack)) - 1;
        }
        return {first, last};
    }

    void deposit(const PhotonLanding& landing, glm::dvec2 from_origin, std::vector<PhotonDeposit>& deposits) const {
        const double x = std::floor(glm::dot(from_origin, to_x_)), y = std::floor(glm::dot(from_origin, to_y_));
        if (!(x >= 0 && x < plan_.width && y >= 0 && y < plan_.height)) return;
        const double value = landing.power_w * (per_ground_area_ ? landing.normal.z : 1);
        deposits.push_back({static_cast<std::int64_t>(y) * plan_.width + static_cast<std::int64_t>(x), value});
    }

    FloorPlan plan_;
    glm::dvec2 to_x_, to_y_;
    bool per_ground_area_;
    std::vector<glm::dvec2> repeats_;  ///< from a landing to where it shows, seen from the map's origin
};

class PhotonFloorCpu final : public PhotonFloor {
  public:
    explicit PhotonFloorCpu(const PhotonSettings& settings) : s_(settings) { validate(s_); }

    std::string_view backend() const override { return "cpu"; }
    double error_estimate() const override { return error_; }
    int passes() const override { return passes_; }
    std::int64_t photons() const override { return passes_ * photons_of_pass(s_.options); }

    void compute(const Surface& surface, FloorMap& map) override {
        PhotonSums sums;
        add(surface, s_.options.passes, s_.options.tolerance, sums);
        show(surface, sums, map);
    }

    void add(const Surface& surface, int passes, PhotonSums& sums) const override { add(surface, passes, 0, sums); }

    void show(const Surface& surface, const PhotonSums& sums, FloorMap& map) override {
        const FloorPlan& plan = s_.floor.plan;
        if (sums.passes < 1) throw InputError("photons: a map is asked for before the first pass");
        check(sums);
        passes_ = sums.passes;
        if (map.irradiance.nx() != plan.width || map.irradiance.ny() != plan.height)
            map.irradiance = Field<float>(plan.width, plan.height);
        const Field<double> smooth = blurred(sums.power_w, blur(surface));
        const double scale = 1 / (sums.passes * plan.pitch_m.x * plan.pitch_m.y);
        std::ranges::transform(smooth.values(), map.irradiance.values().begin(),
                               [&](double power) { return static_cast<float>(scale * power); });
        map.window = {1, 1};
        map.ledger = mean(sums);
        error_ = error(smooth, sums);
    }

  private:
    /// Until `tolerance` is met, at most `passes`.
    void add(const Surface& surface, int passes, double tolerance, PhotonSums& sums) const {
        const FloorPlan& plan = s_.floor.plan;
        check(surface);
        if (sums.passes == 0) {
            sums.power_w = Field<double>(plan.width, plan.height);
            sums.squares_w2 = Field<double>(plan.width, plan.height);
        }
        check(sums);
        if (!is_lit(s_)) {
            sums.passes += passes;
            return;
        }
        std::optional<WaterScene> scene;
        const std::unique_ptr<PhotonTracer> tracer = make_tracer(surface, scene);
        const MapReceiver receiver(s_, surface);
        const BlurSettings smoothing = blur(surface);
        Field<double> pass(plan.width, plan.height);
        for (int k = 0; k < passes; ++k) {
            pass.fill(0);
            run_pass(*tracer, photons_of_pass(s_.options), sums.passes, receiver, pass, sums.ledger);
            take(pass, smoothing, sums);
            if (tolerance > 0 && sums.passes >= 2 && error(blurred(sums.power_w, smoothing), sums) <= tolerance) return;
        }
    }

    std::unique_ptr<PhotonTracer> make_tracer(const Surface& surface, std::optional<WaterScene>& scene) const {
        if (is_open_water(s_, surface)) return make_open_water_tracer(s_, surface);
        scene.emplace(make_photon_scene(s_, surface));
        return make_scene_tracer(s_, *scene);
    }

    static void take(const Field<double>& pass, const BlurSettings& smoothing, PhotonSums& sums) {
        const Field<double> smooth = blurred(pass, smoothing);
        double *power = sums.power_w.data(), *squares = sums.squares_w2.data();
        for (std::size_t i = 0; i < pass.size(); ++i) {
            power[i] += pass.data()[i];
            squares[i] += smooth.data()[i] * smooth.data()[i];
        }
        ++sums.passes;
    }

    /// Variance of the mean of P passes: (mean of squares - square of the mean) / (P - 1). What the noise adds to the
    /// square of the map is taken out of it.
    static double error(const Field<double>& smooth, const PhotonSums& sums) {
        if (sums.passes < 2) return std::numeric_limits<double>::quiet_NaN();
        const double passes = sums.passes;
        double variance = 0, square = 0;
        for (std::size_t i = 0; i < smooth.size(); ++i) {
            const double mean = smooth.data()[i] / passes;
            variance += std::max(0.0, sums.squares_w2.data()[i] / passes - mean * mean) / (passes - 1);
            square += mean * mean;
        }
        if (square == 0) return 0;
        return std::sqrt(variance / std::max(square - variance, 1e-3 * square));
    }

    static FloorLedger mean(const PhotonSums& sums) {
        const FloorLedger& of = sums.ledger;
        const double share = 1.0 / sums.passes;
        return {.incident_w = share * of.incident_w,
                .reflected_w = share * of.reflected_w,
                .extinguished_w = share * of.extinguished_w,
                .floor_w = share * of.floor_w,
                .outside_w = share * of.outside_w,
                .lost_w = share * of.lost_w,
                .objects_w = share * of.objects_w,
                .entered_w = share * of.entered_w};
    }

    BlurSettings blur(const Surface& surface) const {
        const FloorPlan& plan = s_.floor.plan;
        const glm::dvec2 size = plan.pitch_m * glm::dvec2(plan.width, plan.height);
        const PhotonDomain domain(surface);
        const auto round = [&](int axis) {
            const bool one_period = std::abs(size[axis] - domain.size_m[axis]) < 1e-9 * domain.size_m[axis];
            return domain.periodic(axis) && plan.angle_deg == 0 && one_period;
        };
        return {s_.options.blur_pixels, round(0), round(1)};
    }

    void check(const Surface& surface) const {
        if (s_.bed_m && (s_.bed_m->nx() != surface.grid.nx || s_.bed_m->ny() != surface.grid.ny))
            throw InputError("photons: the ground must have the cells of the surface");
    }

    void check(const PhotonSums& sums) const {
        const FloorPlan& plan = s_.floor.plan;
        for (const Field<double>* field : {&sums.power_w, &sums.squares_w2})
            if (field->nx() != plan.width || field->ny() != plan.height)
                throw InputError(fmt::format("photons: sums of {} x {} pixels; allowed: the map's {} x {}", field->nx(),
                                             field->ny(), plan.width, plan.height));
    }

    PhotonSettings s_;
    double error_ = std::numeric_limits<double>::quiet_NaN();
    int passes_ = 0;
};

}  // namespace

std::unique_ptr<PhotonFloor> make_photon_floor(const PhotonSettings& settings) {
    return std::make_unique<PhotonFloorCpu>(settings);
}

}  // namespace waterlight
