// What the surface and the floor map look like as VTK frames.
#pragma once

#include "caustics/floor.hpp"
#include "export/vti.hpp"
#include "sim/shallow_water.hpp"
#include "sim/surface.hpp"

namespace waterlight {

/// At z = 0: "elevation" (m), and where the model has them "velocity" (m/s, three components, the third zero) and
/// "depth" (m). Borrows the surface's fields.
VtiFrame surface_frame(const Surface& surface);

/// At z = -depth_m, turned as the plan is: "irradiance" (W/m2). Borrows the map.
VtiFrame floor_frame(const FloorPlan& plan, double depth_m, double time_s, const Field<float>& irradiance);

/// At z = 0: "bed" (m, the ground) and, of "max_elevation" (m), "max_speed" (m/s) and "arrival_time" (s), those whose
/// names are in `wanted`. Borrows the fields.
VtiFrame extremes_frame(const Grid& grid, double time_s, const Field<float>& bed_m, const ShallowRecords& records,
                        const std::vector<std::string>& wanted);

}  // namespace waterlight
