#include "export/frames.hpp"

#include <algorithm>
#include <cassert>

namespace waterlight {

namespace {

VtiFrame frame_of(const Grid& grid, double time_s) {
    VtiFrame frame;
    frame.cells = {grid.nx, grid.ny, 0};
    frame.origin_m = {grid.x0_m, grid.y0_m, 0};
    frame.pitch_m = {grid.dx_m, grid.dy_m, 1};
    frame.time_s = time_s;
    return frame;
}

}  // namespace

VtiFrame surface_frame(const Surface& surface) {
    VtiFrame frame = frame_of(surface.grid, surface.time_s);
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

VtiFrame wall_frame(const WaterBody& water, int wall, const WallPlan& plan, const Field<float>& irradiance) {
    assert(irradiance.nx() == plan.columns && irradiance.ny() == plan.rows);
    const Grid& g = water.grid;
    const bool along_y = wall < 2;
    VtiFrame frame;
    frame.cells = along_y ? glm::ivec3{0, plan.columns, plan.rows} : glm::ivec3{plan.columns, 0, plan.rows};
    frame.origin_m = {wall == 1 ? g.x0_m + g.width_m() : g.x0_m, wall == 3 ? g.y0_m + g.height_m() : g.y0_m,
                      -water.depth_m};
    frame.pitch_m = {along_y ? 1 : plan.pitch_m.x, along_y ? plan.pitch_m.x : 1, plan.pitch_m.y};
    frame.time_s = water.time_s;
    frame.arrays.push_back({"irradiance", {irradiance.values()}});
    return frame;
}

VtiFrame extremes_frame(const Grid& grid, double time_s, const Field<float>& bed_m, const ShallowRecords& records,
                        const std::vector<std::string>& wanted) {
    VtiFrame frame = frame_of(grid, time_s);
    frame.arrays.push_back({"bed", {bed_m.values()}});
    const std::pair<const char*, const Field<float>*> fields[] = {{"max_elevation", &records.max_elevation_m},
                                                                  {"max_speed", &records.max_speed_m_s},
                                                                  {"arrival_time", &records.arrival_s}};
    for (const auto& [name, field] : fields)
        if (std::find(wanted.begin(), wanted.end(), name) != wanted.end())
            frame.arrays.push_back({name, {field->values()}});
    return frame;
}

VtiFrame volume_frame(const WaterBody& water, glm::ivec3 cells, const Field<float>& plane_irradiance,
                      const Field<float>& scalar_irradiance) {
    const Grid& grid = water.grid;
    VtiFrame frame;
    frame.cells = cells;
    frame.origin_m = {grid.x0_m, grid.y0_m, -water.depth_m};
    frame.pitch_m = {grid.width_m() / cells.x, grid.height_m() / cells.y, water.depth_m / cells.z};
    frame.time_s = water.time_s;
    frame.arrays.push_back({"plane_irradiance", {plane_irradiance.values()}});
    frame.arrays.push_back({"scalar_irradiance", {scalar_irradiance.values()}});
    return frame;
}

VtiFrame picture_frame(double time_s, const Field<float>& radiance) {
    VtiFrame frame;
    frame.cells = {radiance.nx(), radiance.ny(), 0};
    frame.time_s = time_s;
    frame.arrays.push_back({"radiance", {radiance.values()}});
    return frame;
}

}  // namespace waterlight
