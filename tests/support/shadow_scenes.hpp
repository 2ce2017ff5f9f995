// A ball, or something else, in or above a pool, for tests of what its beams leave dark.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "caustics/beam_volume.hpp"
#include "caustics/kernels/optics.hpp"
#include "caustics/objects/object_set.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight::test {

inline std::shared_ptr<const ObjectSet> objects_of(std::vector<Object> objects) {
    return std::make_shared<ObjectSet>(std::move(objects));
}

inline Object ball(double radius_m, glm::dvec3 centre_m) {
    return {.name = "ball", .shape = Sphere{radius_m}, .centre_m = centre_m};
}

/// The ball of most tests, its disc (m2), and places for it.
inline constexpr double radius = .3, disc = std::numbers::pi * radius * radius;
inline const glm::dvec3 in_water{1.7, 1.4, -.9}, in_air{1.7, 1.4, .8};

/// Of the sun, as a test's name.
inline std::string elevation_of(const testing::TestParamInfo<double>& sun) {
    return "at_" + std::to_string(static_cast<int>(sun.param));
}

/// A pool of 4 x 3 x 2 m.
struct ShadowPool {
    Formula waves = flat;
    Boundary boundary{Side::periodic, Side::periodic};
    bool reflected = false;
    BeamSettings beams;

    ShadowPool() {
        beams.grid = {40, 30};
        beams.depth_m = 2;
        beams.sun = {90, 0, 1};
    }

    Surface surface() const { return sample(make_grid(128, 96, 4, 3), boundary, waves); }

    Beams made() const {
        Beams b;
        reflected ? make_reflected_beams(beams, surface(), b) : make_beams(beams, surface(), b);
        return b;
    }
    /// Without its objects.
    Beams bare() const {
        ShadowPool other = *this;
        other.beams.objects = nullptr;
        return other.made();
    }

    /// Of light in still water.
    f64::Refraction light() const {
        return f64::refract_sun(beams.sun.direction(), {0, 0}, beams.optics.refractive_index, 1);
    }
    /// W/m2 on the horizontal plane that enter still water.
    double entering() const { return beams.sun.irradiance_w_m2 * light().incident * light().transmittance; }
};

/// The fields of a pool with its objects and without.
struct ShadowFields {
    Beams beams, bare;
    BeamVolume volume, bare_volume;
    explicit ShadowFields(const ShadowPool& pool, glm::ivec3 cells = {64, 48, 40})
        : beams(pool.made()), bare(pool.bare()) {
        fill_volume(beams, cells, volume);
        fill_volume(bare, cells, bare_volume);
    }
    /// Area (m2) of even light that a slice lacks.
    double dark_m2(int k, double entering) const {
        return (bare_volume.ledger[k].flux_w - volume.ledger[k].flux_w) / entering;
    }
};

}  // namespace waterlight::test
