#include "caustics/demand.hpp"

#include <cmath>

namespace waterlight {

double caustic_contrast(double k, double a, double depth_m, double refractive_index) {
    return depth_m * (1 - 1 / refractive_index) * a * k * k;
}

double focus_depth(double k, double a, double refractive_index) { return 1 / ((1 - 1 / refractive_index) * a * k * k); }

double landing_distance(double slope, double depth_m, double a, double refractive_index) {
    const double incident = std::atan(slope);
    return (depth_m + a) * std::tan(incident - std::asin(std::sin(incident) / refractive_index));
}

}  // namespace waterlight
