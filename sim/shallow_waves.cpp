#include "sim/shallow_waves.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace waterlight {

namespace {

struct Departure {
    double elevation_m = 0;
    glm::dvec2 velocity_m_s{0, 0};
};

Departure departure(const Sine& sine, glm::dvec2 at, double depth, double g) {
    const double elevation = std::max(evaluate(sine, 0, at, 0).elevation_m, -depth);
    const double speed = 2 * (std::sqrt(g * (depth + elevation)) - std::sqrt(g * depth));
    return {elevation, speed * glm::normalize(wave_vector(sine))};
}

}  // namespace

void add_waves(const std::vector<Sine>& sines, const std::vector<StandingWave>& standing,
               ShallowWaterSettings& settings) {
    const Grid& grid = settings.grid;
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) {
            const double depth = settings.depth_m(i, j);
            if (depth <= 0) continue;
            const glm::dvec2 at{grid.x_m(i), grid.y_m(j)};
            Departure sum;
            for (const Sine& sine : sines) {
                const Departure one = departure(sine, at, depth, settings.water.gravity_m_s2);
                sum.elevation_m += one.elevation_m;
                sum.velocity_m_s += one.velocity_m_s;
            }
            for (const StandingWave& wave : standing) sum.elevation_m += evaluate(wave, grid, 0, at, 0).elevation_m;
            settings.depth_m(i, j) = std::max(depth + sum.elevation_m, 0.0);
            settings.velocity_x_m_s(i, j) += sum.velocity_m_s.x;
            settings.velocity_y_m_s(i, j) += sum.velocity_m_s.y;
        }
}

}  // namespace waterlight
