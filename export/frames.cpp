#include "export/frames.hpp"

#include <cassert>

namespace waterlight {

VtiFrame surface_frame(const Surface& surface) {
    const Grid& grid = surface.grid;
    VtiFrame frame;
    frame.cells = {grid.nx, grid.ny, 0};
    frame.origin_m = {grid.x0_m, grid.y0_m, 0};
    frame.pitch_m = {grid.dx_m, grid.dy_m, 1};
    frame.time_s = surface.time_s;
    frame.arrays.push_back({"elevation", {surface.elevation.values()}});
    if (surface.velocity_x && surface.velocity_y) {
        frame.arrays.push_back({"velocity", {surface.velocity_x->values(), surface.velocity_y->values(), {}}});
    }
    if (surface.depth) frame.arrays.push_back({"depth", {surface.depth->values()}});
    return frame;
}

VtiFrame floor_frame(const FloorPlan& plan, double depth_m, double time_s, const Field<float>& irradiance) {
    assert(irradiance.nx() == plan.width && irradiance.ny() == plan.height);
    VtiFrame frame;
    frame.cells = {plan.width, plan.height, 0};
    frame.origin_m = {plan.origin_m.x, plan.origin_m.y, -depth_m};
    frame.pitch_m = {plan.pitch_m.x, plan.pitch_m.y, 1};
    frame.angle_deg = plan.angle_deg;
    frame.time_s = time_s;
    frame.arrays.push_back({"irradiance", {irradiance.values()}});
    return frame;
}

}  // namespace waterlight
