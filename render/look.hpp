// What a picture shows beyond what the run computes: materials, sky, exposure. None of it changes a field.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "caustics/water_colour.hpp"

namespace waterlight {

/// How a surface of the pool or the ground looks. Every one is a diffuse (Lambertian) reflector.
struct Finish {
    enum class Pattern { plain, tiles, sand };
    Pattern pattern = Pattern::plain;
    glm::dvec3 albedo{0.8, 0.8, 0.8};  ///< linear red, green, blue, each in [0, 1]
    double tile_m = 0.25;              ///< side of a tile; of sand, the distance of its ripples; > 0
    bool operator==(const Finish&) const = default;
};

/// Diffuse light from above. Its radiance is a pattern of direction times a strength that makes its irradiance on the
/// horizontal plane what is stated.
struct Sky {
    enum class Type { clear, uniform };
    Type type = Type::clear;
    std::optional<double> irradiance_w_m2;  ///< on the horizontal plane; none: a sixth of the sun's E0
    bool operator==(const Sky&) const = default;
};

/// Fields shown as colours instead of the material's own.
enum class Overlay { none, elevation, irradiance, error };

struct OverlayRange {
    double low = 0, high = 1;  ///< in the field's unit, at the ends of the colour map
    bool operator==(const OverlayRange&) const = default;
};

struct Look {
    Finish floor{.pattern = Finish::Pattern::tiles};
    Finish walls{.pattern = Finish::Pattern::tiles};
    Finish deck{.pattern = Finish::Pattern::plain, .albedo = {0.55, 0.52, 0.48}};  ///< around a pool
    Sky sky;
    double freeboard_m = 0.1;  ///< how far walls rise above still water, >= 0
    /// Radiance (W/(m2 sr)) that the tone curve takes for 1; none: that of a white diffuse plane in sun and sky, for a
    /// camera in the water what of it is left at its depth below flat water, in the mean of the colours.
    std::optional<double> exposure_w_m2_sr;
    int samples = 4;  ///< of a pixel along edges: 1, 2, 4 or 8, or the most that the device has
    /// Absorption (1/m) of red, green and blue beyond the scenario's own, on the light's way and on the camera's. The
    /// default is that of pure water (Pope & Fry 1997) at 650, 550 and 450 nm.
    glm::dvec3 colour_per_m{pure_water_absorption(650), pure_water_absorption(550), pure_water_absorption(450)};
    Overlay overlay = Overlay::none;
    OverlayRange range;
    bool operator==(const Look&) const = default;
};

}  // namespace waterlight
