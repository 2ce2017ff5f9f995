// The ways to a floor map, each with how finely it samples: what docs/methods.md compares.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "caustics/floor.hpp"

namespace waterlight::methods {

/// Makes the map of a surface; holds its buffers between calls.
using Mapper = std::function<void(const Surface& surface, FloorMap& map)>;

struct Method {
    std::string name;
    bool converges = true;  ///< with the resolution, by what its source says
    double energy = 1e-3;   ///< how far its light may be from incident less reflected, relative
    /// `finer` samples along each axis of a pixel: quads, vertices, beams, photons.
    std::function<Mapper(const FloorSettings& settings, int finer)> make{};
};

/// Two-pass with both footprints, quads, splats fixed and sized, photons without and with blur, beams at the floor.
std::vector<Method> all_methods();

/// Photons that `finer` of 1 means a pixel, along each axis.
inline constexpr int photons_along_pixel = 4;

/// Photons of so many along each axis of a pixel, smoothed by a Gaussian of so many pixels; 0: not.
Mapper photons(const FloorSettings& settings, int along, double blur_pixels);

/// Pixels of the blur's standard deviation where photons are blurred.
inline constexpr double photon_blur = 1;

}  // namespace waterlight::methods
