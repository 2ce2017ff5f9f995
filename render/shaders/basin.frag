// Floor, walls and deck as they are seen directly.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "render/shaders/includes.glsl"
#include "render/shaders/light.glsl"
#include "render/shaders/water.glsl"
#include "render/shaders/surface_cells.glsl"
#include "render/shaders/dry.glsl"

layout(location = 0) flat in int part;
layout(location = 0) out vec4 drawn;

// The ray's parameter at the rectangle's plane.
float plane_way(Sight a) {
    if (kind == KIND_FLOOR) return (-s.depth - p.eye_z) / a.r.z;
    if (kind == KIND_DECK) return (s.freeboard - p.eye_z) / a.r.z;
    return part < 2 ? ((part == 0 ? s.x0 : s.x1) - p.eye_x) / a.r.x : ((part == 2 ? s.y0 : s.y1) - p.eye_y) / a.r.y;
}

// Whether a place on a wall is above the water. To a camera inside the water hides all that is.
bool is_dry(vec3 place) {
    if (in_water && !outside) return false;
    return !in_water || place.z > elevation_at(cells_around(cells_of(place.xy)));
}

void main() {
    Sight a = sight(gl_FragCoord.xy);
    float t = way_of_fragment(1 / plane_way(a));
    vec3 place = eye() + t * a.r;
    float width = t * pixel_width();
    int wall = kind == KIND_WALLS ? part : -1;
    vec3 plane = wall < 0 ? vec3(0, 0, 1) : wall_inward(wall);
    vec2 widths = widths_on_pattern(wall, moved_along(unmoved, turn_of_sight(a), a.d, t * a.metres, plane));
    if (kind == KIND_DECK) {
        drawn = exposed(deck(place, widths, 1));
        return;
    }
    if (wall >= 0 && is_dry(place)) {
        drawn = exposed(dry_wall(wall, place, widths, 1));
        return;
    }
    vec3 radiance = radiance_in_water(wall, place, width, widths, 1);
    drawn = exposed(through_water(radiance, a.d, t * a.metres));
}
