// Scenes whose pictures are known.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>
#include <numbers>

#include "render/scene_renderer.hpp"
#include "tests/support/gpu_fixture.hpp"

namespace waterlight {

/// A picture's radiance in the pixel (i, j).
inline glm::dvec3 radiance_at(const Radiance& all, int i, int j) {
    const float* rgb = all.rgb.data() + 3 * (static_cast<std::ptrdiff_t>(j) * all.size.x + i);
    return {rgb[0], rgb[1], rgb[2]};
}

/// A flat surface of 8 by 6 m.
inline Surface calm_surface(Side side) { return {make_grid(32, 24, 8, 6), {side, side}}; }

/// The same with waves of two directions.
inline Surface wavy_surface(Side side) {
    Surface s = calm_surface(side);
    const double k = 2 * std::numbers::pi / 2, l = 2 * std::numbers::pi / 3;  // wavelengths 2 m and 3 m fit the sides
    for (int j = 0; j < s.grid.ny; ++j)
        for (int i = 0; i < s.grid.nx; ++i) {
            const double x = s.grid.x_m(i), y = s.grid.y_m(j);
            s.elevation(i, j) = static_cast<float>(0.02 * std::cos(k * x) + 0.03 * std::cos(l * y));
            s.slope_x(i, j) = static_cast<float>(-0.02 * k * std::sin(k * x));
            s.slope_y(i, j) = static_cast<float>(-0.03 * l * std::sin(l * y));
        }
    return s;
}

inline Look plain_look(double albedo) {
    const Finish plain{.pattern = Finish::Pattern::plain, .albedo = glm::dvec3(albedo)};
    Look look;
    look.floor = look.walls = look.deck = plain;
    look.sky = {.type = Sky::Type::uniform, .irradiance_w_m2 = 300.0};
    look.colour_per_m = {0, 0, 0};
    return look;
}

inline Camera camera_at(glm::dvec3 from, glm::dvec3 to, glm::ivec2 size = {160, 120}) {
    Camera camera;
    camera.position_m = from;
    camera.target_m = to;
    camera.size = size;
    return camera;
}

}  // namespace waterlight
