// Copies of what stages hold into buffers that are there already: nothing is allocated while sizes stay.
#pragma once

#include <optional>

#include "caustics/beam_image.hpp"
#include "caustics/beam_volume.hpp"
#include "caustics/walls.hpp"
#include "sim/surface.hpp"

namespace waterlight {

template <class T>
void copy(const Field<T>& from, Field<T>& to) {
    if (to.nx() != from.nx() || to.ny() != from.ny()) to = Field<T>(from.nx(), from.ny());
    std::copy_n(from.data(), from.size(), to.data());
}

template <class T>
void copy(const std::optional<Field<T>>& from, std::optional<Field<T>>& to) {
    if (!from) return to.reset();
    if (!to) to.emplace();
    copy(*from, *to);
}

void copy(const Surface& from, Surface& to);
void copy(const BeamVolume& from, BeamVolume& to);
void copy(const BeamImage& from, BeamImage& to);
void copy(const WallMaps& from, WallMaps& to);

}  // namespace waterlight
