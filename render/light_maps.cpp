#include "render/light_maps.hpp"

#include <algorithm>
#include <cmath>

namespace waterlight {

namespace {

/// Width and height of a level: as ceil() of the shader has them.
glm::ivec2 level_size(glm::ivec2 size, int level) {
    const int round = (1 << level) - 1;
    return {(size.x + round) >> level, (size.y + round) >> level};
}

int padded(glm::ivec2 size) { return (size.x + 2) * (size.y + 2); }

/// Whether the map is that of one period along each axis, so that its margin is its other side.
glm::bvec2 repeats(const Scene& scene) {
    const Grid& g = scene.surface->grid;
    const FloorPlan& plan = scene.floor_plan;
    const auto covers = [](double pitch, int pixels, double from, double extent, double start) {
        return std::abs(pitch * pixels - extent) < 1e-6 * extent && std::abs(from - start) < 1e-6 * extent;
    };
    const bool straight = plan.angle_deg == 0;
    return {straight && scene.surface->boundary.x == Side::periodic &&
                covers(plan.pitch_m.x, plan.width, plan.origin_m.x, g.width_m(), g.x0_m),
            straight && scene.surface->boundary.y == Side::periodic &&
                covers(plan.pitch_m.y, plan.height, plan.origin_m.y, g.height_m(), g.y0_m)};
}

void fill_margin(float* first, glm::ivec2 size, glm::bvec2 repeat) {
    const int stride = size.x + 2;
    const auto at = [&](int i, int j) -> float& { return first[(j + 1) * stride + i + 1]; };
    for (int j = 0; j < size.y; ++j) {
        at(-1, j) = at(repeat.x ? size.x - 1 : 0, j);
        at(size.x, j) = at(repeat.x ? 0 : size.x - 1, j);
    }
    std::copy_n(&at(-1, repeat.y ? size.y - 1 : 0), stride, &at(-1, -1));
    std::copy_n(&at(-1, repeat.y ? 0 : size.y - 1), stride, &at(-1, size.y));
}

void copy_inside(const Field<float>& from, float* first) {
    const int stride = from.nx() + 2;
    for (int j = 0; j < from.ny(); ++j) std::copy_n(from.row(j), from.nx(), first + (j + 1) * stride + 1);
}

void halve(const float* from, glm::ivec2 finer, float* first, glm::ivec2 size) {
    const int stride = finer.x + 2;
    const auto at = [&](int i, int j) {
        return from[(std::min(j, finer.y - 1) + 1) * stride + std::min(i, finer.x - 1) + 1];
    };
    for (int j = 0; j < size.y; ++j)
        for (int i = 0; i < size.x; ++i)
            first[(j + 1) * (size.x + 2) + i + 1] =
                0.25F * (at(2 * i, 2 * j) + at(2 * i + 1, 2 * j) + at(2 * i, 2 * j + 1) + at(2 * i + 1, 2 * j + 1));
}

void fill_walls(const WallMaps& walls, LightMaps& maps) {
    for (int wall = 0; wall < 4; ++wall) {
        const Field<float>& map = walls.irradiance[wall];
        if (map.empty()) continue;
        const glm::ivec2 size{map.nx(), map.ny()};
        maps.wall_offset[wall] = static_cast<int>(maps.values.size());
        maps.values.resize(maps.values.size() + padded(size));
        float* const first = maps.values.data() + maps.wall_offset[wall];
        copy_inside(map, first);
        fill_margin(first, size, {false, false});
    }
}

}  // namespace

void fill_maps(const Scene& scene, Overlay overlay, LightMaps& maps) {
    std::vector<const Field<float>*> colours;
    if (overlay == Overlay::error)
        colours = {scene.error};
    else if (scene.floor_rgb[0] != nullptr)
        colours.assign(scene.floor_rgb.begin(), scene.floor_rgb.end());
    else
        colours = {scene.floor};
    maps.values.clear();
    maps.levels = 0;
    if (colours[0] != nullptr) {
        const glm::ivec2 size{scene.floor_plan.width, scene.floor_plan.height};
        const glm::bvec2 repeat = repeats(scene);
        int level = 0;
        do {
            maps.floor_offset[level] = static_cast<int>(maps.values.size());
            maps.values.resize(maps.values.size() + colours.size() * padded(level_size(size, level)));
        } while (++level < LightMaps::most_levels && std::min(size.x, size.y) >> level > 0);
        maps.levels = level;
        for (int k = 0; k < maps.levels; ++k)
            for (std::size_t c = 0; c < colours.size(); ++c) {
                const glm::ivec2 own = level_size(size, k);
                float* const first = maps.values.data() + maps.floor_offset[k] + c * padded(own);
                if (k == 0) {
                    copy_inside(*colours[c], first);
                } else {
                    const glm::ivec2 finer = level_size(size, k - 1);
                    halve(maps.values.data() + maps.floor_offset[k - 1] + c * padded(finer), finer, first, own);
                }
                fill_margin(first, own, repeat);
            }
    }
    if (scene.walls != nullptr) fill_walls(*scene.walls, maps);
}

}  // namespace waterlight
