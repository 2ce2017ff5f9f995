#include "caustics/splat/splat_cloud.hpp"

#include "caustics/light_ledger.hpp"

#include <cmath>

namespace waterlight {

void FlightAccount::add(const FlightAccount& o) {
    ledger += o.ledger;
    report.vertices += o.report.vertices;
    report.not_converged += o.report.not_converged;
    report.missed += o.report.missed;
    step2_m2 += o.step2_m2;
}

SplatReport FlightAccount::summed_report() const {
    SplatReport all = report;
    const std::int64_t landed = report.vertices - report.missed;
    all.last_step_m = landed > 0 ? std::sqrt(step2_m2 / static_cast<double>(landed)) : 0;
    return all;
}

void FlightAccount::finish(SplatCloud& cloud) const {
    cloud.ledger = ledger;
    cloud.report = summed_report();
}

Arrival Lander::operator()(const Flight& f, FlightAccount& account) const {
    const Landed landed = land(options_, frame_.light.image, receivers_, f.start_m, f.direction);
    const glm::dvec2 way = landed.distance_m * glm::dvec2(f.direction);
    Arrival arrival{frame_.plan.pixel(glm::dvec2(f.start_m)) + frame_.to_pixels * way, 0};
    if (!(f.power_w > 0)) return arrival;
    ++account.report.vertices;
    // Light that is not of the domain counts only where it lands on the map.
    const double counted = f.own ? 1 : 0;
    const bool finite = std::isfinite(arrival.pixel.x) && std::isfinite(arrival.pixel.y);
    const double left = finite ? f.power_w * f64::beer_lambert(f.extinction_per_m, landed.distance_m) : f.power_w;
    account.ledger.extinguished_w += counted * (f.power_w - left);
    if (!finite || !landed.seen) {
        ++account.report.missed;
        (finite ? account.ledger.outside_w : account.ledger.lost_w) += counted * left;
        return arrival;
    }
    if (landed.last_step_m > frame_.pixel_m) ++account.report.not_converged;
    account.step2_m2 += landed.last_step_m * landed.last_step_m;
    arrival.power_w = left;
    return arrival;
}

}  // namespace waterlight
