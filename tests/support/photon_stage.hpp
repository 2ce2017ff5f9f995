// A square of floor under the sun overhead, for photons and one object.
#pragma once

#include <utility>

#include "tests/support/photon_maps.hpp"

namespace waterlight::test {

inline Object glass_ball(double radius, glm::dvec3 centre) {
    return {.name = "ball",
            .shape = Sphere{radius},
            .material = {.type = Material::Type::glass, .index = 1.5},
            .centre_m = centre};
}

/// A square of this size about the origin under the sun overhead, with one object; the water is not to be seen.
struct Stage {
    Grid grid;
    Surface surface;
    PhotonSettings settings;
    Stage(double size_m, int pixels, double depth_m, Object object)
        : grid{4, 4, size_m / 4, size_m / 4, -size_m / 2, -size_m / 2},
          surface(grid, {Side::absorbing, Side::absorbing}),
          settings(photons_over(grid, pixels, pixels, 90)) {
        settings.floor.depth_m = depth_m;
        settings.floor.sun.irradiance_w_m2 = 1;
        settings.floor.optics.refractive_index = 1;
        settings.floor.objects = objects({std::move(object)});
    }
    double pitch_m() const { return settings.floor.plan.pitch_m.x; }
    glm::dvec2 place(int i, int j) const { return settings.floor.plan.position_m({i + 0.5, j + 0.5}); }
    FloorMap map() const { return photon_map(settings, surface).map; }
    /// Mean of the map within this distance of the axis.
    double around_axis(const FloorMap& map, double distance) const {
        double sum = 0;
        int pixels = 0;
        for (int j = 0; j < map.irradiance.ny(); ++j)
            for (int i = 0; i < map.irradiance.nx(); ++i)
                if (glm::length(place(i, j)) < distance) {
                    sum += map.irradiance(i, j);
                    ++pixels;
                }
        return sum / pixels;
    }
};

}  // namespace waterlight::test
