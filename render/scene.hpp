// One moment of a scene as a picture needs it: fields that others own, and what they mean.
#pragma once

#include <array>

#include "caustics/beam_image.hpp"
#include "caustics/beam_volume.hpp"
#include "caustics/floor.hpp"
#include "caustics/light.hpp"
#include "caustics/walls.hpp"
#include "sim/surface.hpp"

namespace waterlight {

/// Borrowed for the time of a call. What is null is not there and costs nothing: without a floor map the floor is lit
/// as under flat water, without wall maps the walls are, without volume or beams the water scatters as flat water
/// would.
struct Scene {
    const Surface* surface = nullptr;        ///< never null
    double depth_m = 1;                      ///< of the flat floor
    const Field<float>* ground_m = nullptr;  ///< heights in the middle of the surface's cells; null: the flat floor
    const Field<float>* floor = nullptr;     ///< irradiance, W/m2 (FloorMap)
    std::array<const Field<float>*, 3> floor_rgb{};  ///< of red, green, blue, in place of `floor`; all or none
    FloorPlan floor_plan;                            ///< of either
    const WallMaps* walls = nullptr;
    WallSettings wall_settings;           ///< of the wall maps
    const BeamVolume* volume = nullptr;   ///< for a camera above the water: light scattered below it
    const BeamImage* beams = nullptr;     ///< for a camera in the water: of the same view, of any size
    const Field<float>* error = nullptr;  ///< shown by Overlay::error, on the floor's pixels
    Sun sun;
    WaterOptics optics;
};

}  // namespace waterlight
