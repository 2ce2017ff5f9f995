// What the surface and the floor map look like as VTK frames.
#pragma once

#include "caustics/floor.hpp"
#include "caustics/walls.hpp"
#include "export/vti.hpp"
#include "sim/shallow_water.hpp"
#include "sim/surface.hpp"

namespace waterlight {

/// At z = 0: "elevation" (m), and where the model has them "velocity" (m/s, three components, the third zero) and
/// "depth" (m). Borrows the surface's fields.
VtiFrame surface_frame(const Surface& surface);

/// At z = -depth_m, turned as the plan is: "irradiance" (W/m2). Borrows the map.
VtiFrame floor_frame(const FloorPlan& plan, double depth_m, double time_s, const Field<float>& irradiance);

/// Where and when the water is that a frame of fields covers.
struct WaterBody {
    Grid grid;
    double depth_m = 1;
    double time_s = 0;
};

/// A wall of this body of water, upright in its place, wall 0 to 3 as in wall_names: "irradiance" (W/m2 of wall).
/// Borrows the map.
VtiFrame wall_frame(const WaterBody& water, int wall, const WallPlan& plan, const Field<float>& irradiance);

/// At z = 0: "bed" (m, the ground) and, of "max_elevation" (m), "max_speed" (m/s) and "arrival_time" (s), those whose
/// names are in `wanted`. Borrows the fields.
VtiFrame extremes_frame(const Grid& grid, double time_s, const Field<float>& bed_m, const ShallowRecords& records,
                        const std::vector<std::string>& wanted);

/// From the floor to still water: "plane_irradiance" and "scalar_irradiance" (W/m2), the deepest slice first. Borrows
/// the fields.
VtiFrame volume_frame(const WaterBody& water, glm::ivec3 cells, const Field<float>& plane_irradiance,
                      const Field<float>& scalar_irradiance);

/// A camera's picture: "radiance" (W/(m2 sr)), each pixel a cell of width 1, from the lower left corner. Borrows it.
VtiFrame picture_frame(double time_s, const Field<float>& radiance);

}  // namespace waterlight
