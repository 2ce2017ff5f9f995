// Short ways to maps by caustics mapping.
#pragma once

#include "caustics/splat/splat.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight::test {

inline SplatSettings splat_settings(const Grid& grid, int width, int height, double elevation_deg) {
    SplatSettings s;
    s.floor.plan = cover(grid, width, height);
    s.floor.sun = {elevation_deg, 30, 1000};
    s.options.grid = std::max(width, height);
    return s;
}

inline FloorMap splat_map(const SplatSettings& settings, const Surface& surface, SplatReport* report = nullptr) {
    FloorMap map;
    const auto mapper = make_splat_floor_cpu(settings);
    mapper->compute(surface, map);
    if (report != nullptr) *report = mapper->report();
    return map;
}

}  // namespace waterlight::test
