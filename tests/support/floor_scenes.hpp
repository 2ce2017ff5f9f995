// Scenes on which the methods of the floor map are measured against the truth.
#pragma once

#include <cmath>

#include "caustics/floor.hpp"
#include "tests/support/sides.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight::test {

inline const double root_two = std::sqrt(2.0);

inline FloorMap map_of(const FloorSettings& settings, const Surface& surface) {
    FloorMap map;
    make_floor_cpu(settings)->compute(surface, map);
    return map;
}

/// Waves of 0.5 m over one period of their pattern.
struct FloorScene {
    Formula waves;
    glm::dvec2 period_m;
    double depth_m;
    Sun sun{90, 0, 1};
    double aspect = 1;  ///< dx / dy
    double truth_tolerance = 1e-4;
    int rows = 0;  ///< of pixels, of what is the same along y; 0: a whole period
};

inline FloorScene sine(double depth_m) {
    return {.waves = sines({{.01, .5, 0}}), .period_m = {.5, .5}, .depth_m = depth_m, .rows = 4};
}

inline FloorScene crate(double depth_m) {
    return {.waves = egg_crate(.006, .5), .period_m = {.5, .5}, .depth_m = depth_m};
}

inline FloorScene crossed(double depth_m) {
    return {.waves = sines({{.005, .5, 45}, {.004, .5, 135}}),
            .period_m = {.5 * root_two, .5 * root_two},
            .depth_m = depth_m};
}

inline FloorScene skew(double azimuth_deg) {
    return {.waves = sines({{.01, .5, 30}}),
            .period_m = {1 / std::sqrt(3.0), 1},
            .depth_m = 2,
            .sun = {45, azimuth_deg, 1},
            .aspect = 2,
            .truth_tolerance = 5e-4};
}

struct SolvedFloor {
    Surface surface;
    FloorSettings settings;
    TruthMap truth;
};

/// The scene at about so many pixels a wave, one cell and one sample a pixel, and its truth.
inline SolvedFloor solve(const FloorScene& scene, int per_wave) {
    const double dx = .5 / per_wave, dy = dx / scene.aspect;
    const int nx = static_cast<int>(std::lround(scene.period_m.x / dx));
    const int ny = scene.rows > 0 ? scene.rows : static_cast<int>(std::lround(scene.period_m.y / dy));
    const Grid grid = make_grid(nx, ny, scene.period_m.x, scene.rows > 0 ? ny * dy : scene.period_m.y);
    FloorSettings s;
    s.plan = cover(grid, nx, ny);
    s.depth_m = scene.depth_m;
    s.sun = scene.sun;
    return {sample(grid, periodic, scene.waves), s,
            truth_map({s, 4, 64, scene.truth_tolerance}, as_truth(grid, periodic, scene.waves))};
}

}  // namespace waterlight::test
