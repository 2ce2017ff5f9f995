// Surfaces for tests, sampled from formulas.
#pragma once

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "caustics/truth.hpp"
#include "sim/sines.hpp"
#include "sim/surface.hpp"

namespace waterlight::test {

using Formula = std::function<SurfacePoint(glm::dvec2)>;

inline Surface sample(const Grid& grid, Boundary boundary, const Formula& formula, glm::dvec2 tilt = {0, 0}) {
    Surface s(grid, boundary);
    s.tilt = tilt;
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            const SurfacePoint p = formula({grid.x_m(i), grid.y_m(j)});
            s.elevation(i, j) = static_cast<float>(p.elevation_m);
            s.slope_x(i, j) = static_cast<float>(p.slope.x);
            s.slope_y(i, j) = static_cast<float>(p.slope.y);
        }
    }
    return s;
}

inline SurfacePoint flat(glm::dvec2) { return {}; }

/// A plane of this slope through the origin.
inline Formula tilted(glm::dvec2 slope) {
    return [slope](glm::dvec2 at) { return SurfacePoint{glm::dot(slope, at), slope, 0}; };
}

/// The sum of some sines at time 0.
inline Formula sines(std::vector<Sine> all) {
    return [all = std::move(all)](glm::dvec2 at) {
        SurfacePoint sum;
        for (const Sine& sine : all) {
            const SurfacePoint p = evaluate(sine, 0, at, 0);
            sum.elevation_m += p.elevation_m;
            sum.slope += p.slope;
        }
        return sum;
    };
}

/// Two crossing waves with the symmetry of an egg crate: a (cos kx + cos ky).
inline Formula egg_crate(double amplitude_m, double wavelength_m) {
    return sines({{amplitude_m, wavelength_m, 0}, {amplitude_m, wavelength_m, 90}});
}

inline TruthSurface as_truth(const Grid& grid, Boundary boundary, Formula formula) {
    return {grid, boundary, std::move(formula)};
}

}  // namespace waterlight::test
