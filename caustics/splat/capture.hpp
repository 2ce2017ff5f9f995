// The refractive vertex grid where there are objects: what light meets from the light's image on, and the ways on which
// it goes on to what receives it.
#pragma once

#include "caustics/splat/light_ways.hpp"

namespace waterlight {

/// The last parts of all ways, in rows of the lattice.
struct CapturedLight {
    std::vector<CapturedVertex> all;
    std::vector<glm::ivec4> neighbours;  ///< as of SplatCloud
    std::vector<int> row_begin;
    FlightAccount account;
};

/// Traces the light of each vertex of the lattice through water and objects, both ways at each boundary, until it is on
/// its last way to the ground. Ways that carry less than a thousandth of their vertex's light, or meet too many
/// interfaces, are lost; light that leaves upwards is reflected. Widens the frame's lattice, whose vertices are in the
/// plane z = 0 of still water, to all that lights the domain or an object. Throws InputError where a lamp is not above
/// all water.
CapturedLight capture(const SplatSettings& settings, SplatFrame& frame, const Surface& surface);

/// Lands it.
SplatCloud land_captured(const SplatSettings& settings, const SplatFrame& frame, const Receivers& receivers,
                         CapturedLight light);

}  // namespace waterlight
