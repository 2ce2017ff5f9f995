// Floor, walls and deck as they are seen directly.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "render/shaders/includes.glsl"
#include "render/shaders/light.glsl"
#include "render/shaders/water.glsl"
#include "render/shaders/surface_cells.glsl"

layout(location = 0) flat in int part;
layout(location = 0) out vec4 drawn;

vec3 sky_irradiance() { return vec3(s.sky_r, s.sky_g, s.sky_b); }

// A wall above the water: the sun, half of the sky, and half of what comes up from the water.
vec3 dry_wall(int wall, vec3 place, vec2 widths) {
    float along = wall < 2 ? place.y - s.y0 : place.x - s.x0;
    float sun = s.sun_irradiance * max(0, dot(wall_inward(wall), to_sun()));
    vec3 up = vec3(ambient_from_water(s.sky_r, s.up_r, s.r_ext, s.r_int),
                   ambient_from_water(s.sky_g, s.up_g, s.r_ext, s.r_int),
                   ambient_from_water(s.sky_b, s.up_b, s.r_ext, s.r_int));
    vec3 albedo = vec3(s.wall_r, s.wall_g, s.wall_b) * finish(wall_pattern, vec2(along, place.z), widths, s.wall_side);
    return albedo * (sun + 0.5 * (sky_irradiance() + up)) * (1 / pi);
}

vec3 deck(vec3 place, vec2 widths) {
    vec3 albedo = vec3(s.deck_r, s.deck_g, s.deck_b) * finish(deck_pattern, place.xy, widths, s.deck_side);
    return albedo * (s.sun_irradiance * max(0, s.sun_z) + sky_irradiance()) * (1 / pi);
}

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
        drawn = exposed(deck(place, widths));
        return;
    }
    if (wall >= 0 && is_dry(place)) {
        drawn = exposed(dry_wall(wall, place, widths));
        return;
    }
    vec3 radiance = radiance_in_water(wall, place, width, widths);
    drawn = exposed(through_water(radiance, a.d, t * a.metres));
}
