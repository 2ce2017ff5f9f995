// The floor map on ground that is not flat: triangles of the refracted surface, landed on the ground by iteration and
// shared exactly among the pixels above which they land.
#pragma once

#include "caustics/floor.hpp"

namespace waterlight {

struct ReliefSettings {
    FloorSettings floor;  ///< its plan covers the grid; window and depth_m are not used
    Field<float> bed_m;   ///< height of the ground in each cell of the surface's grid, m above still water; finite
    /// Irradiance is per area of the sloping ground; false: per horizontal area, which multiplies to the same power.
    bool per_ground_area = true;
};

/// Light goes straight from the surface to the first ground it meets, bilinear between the cells; above ground that
/// rises out of the water it lands where it enters. The mesh has the pixels' spacing: the map converges with the pixels
/// as that of parallelograms does. Periodic sides wrap; beyond an absorbing side still water lights the map over ground
/// as high as at the side. Window {1, 1}: no light is lost. The ledger's floor_w is the power on the map whatever the
/// area that irradiance is per. Throws InputError where a setting is out of its range, the plan does not cover the
/// domain, or the bed is not of the surface's grid.
std::unique_ptr<FloorMapper> make_relief_floor(ReliefSettings settings);

}  // namespace waterlight
