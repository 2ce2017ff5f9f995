// Statistics of a run's fields, and of their difference from what they should be.
#pragma once

#include <string>

#include "caustics/beam_image.hpp"
#include "caustics/beam_volume.hpp"
#include "caustics/floor.hpp"
#include "scenarios/scenario.hpp"
#include "sim/surface.hpp"

namespace waterlight {

/// The fields of one frame; what the run does not compute is nullptr.
struct FrameFields {
    const Surface& surface;
    const FloorMap* floor = nullptr;
    const BeamVolume* volume = nullptr;
    const BeamImage* picture = nullptr;
};

/// The number that a check of a field judges, of the frame at time_s: of the field or, where there is a reference (none
/// that is a scenario), of field - reference. A file may have cells smaller by whole numbers: their means count. Of a
/// .pvd the file of the frame's time is taken. Throws InputError where the reference cannot be used, naming it and the
/// check.
double field_value(const Scenario& scenario, const Check& check, double time_s, const FrameFields& frame);

}  // namespace waterlight
