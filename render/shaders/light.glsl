// Irradiance of floor, walls and ground below the water, of three colours: the sun's from the maps, or as under flat
// water where there are none, and the diffuse light's.

vec3 colours() { return vec3(s.colour_r, s.colour_g, s.colour_b); }

float light_at(int offset, int stride, vec2 place) {
    vec2 low = floor(place), w = place - low;
    int k = offset + int(low.y) * stride + int(low.x);
    return bilinear(light_value(k), light_value(k + 1), light_value(k + stride), light_value(k + stride + 1), w.x, w.y);
}

// Whether the sun reaches a place through flat water past the rims of the walls.
float past_walls(vec2 place, float depth) {
    vec2 from = place - depth * vec2(s.travel_x, s.travel_y);
    float lit = 1;
    if (wall_x && (from.x < s.x0 || from.x > s.x1)) lit = 0;
    if (wall_y && (from.y < s.y0 || from.y > s.y1)) lit = 0;
    return lit;
}

vec3 calm_sun(vec2 place, float depth) {
    return s.entering * past_walls(place, depth) * exp(-(s.extinction + colours()) * s.path * depth);
}

vec3 diffuse_absorption() { return vec3(s.absorption_r, s.absorption_g, s.absorption_b); }

bool shows_map() { return overlay == OVERLAY_FLOOR || overlay == OVERLAY_ERROR; }

// What is left of the sun's light beyond what the fields know; of fields that are shown themselves, all.
vec3 left_of_sun(float depth) {
    if (shows_map()) return vec3(1);
    return uneven ? exp(-colours() * s.path * depth) : vec3(s.left_r, s.left_g, s.left_b);
}

int map_offset(int level) {
    int low = level == 0 ? s.map_offset_0 : (level == 1 ? s.map_offset_1 : s.map_offset_2);
    int high = level == 3 ? s.map_offset_3 : (level == 4 ? s.map_offset_4 : s.map_offset_5);
    return level < 3 ? low : high;
}

// `width` is the footprint's, m.
vec3 sun_on_floor(vec2 place, float depth, float width) {
    if (map_colours == 0) return calm_sun(place, depth);
    vec2 home = wrapped(place);
    vec2 pixel = vec2(s.map_x + home.x * s.map_xx + home.y * s.map_xy, s.map_y + home.x * s.map_yx + home.y * s.map_yy);
    int level = clamp(int(floor(log2(max(width / s.map_pitch, 1)) + 0.5)), 0, s.map_levels - 1);
    float scale = exp2(-float(level));
    ivec2 size = ivec2(ceil(vec2(s.map_width, s.map_height) * scale));
    vec2 at = clamp(pixel * scale + 0.5, vec2(0.5), vec2(size) + 0.499);
    int offset = map_offset(level), stride = size.x + 2;
    bool on_map = all(greaterThanEqual(pixel, vec2(-0.5))) &&
                  all(lessThanEqual(pixel, vec2(s.map_width, s.map_height) + 0.5));
    vec3 e;
    if (map_colours == 1) {
        e = light_at(offset, stride, at) * left_of_sun(depth);
    } else {
        int plane = stride * (size.y + 2);
        e = vec3(light_at(offset, stride, at), light_at(offset + plane, stride, at),
                 light_at(offset + 2 * plane, stride, at));
    }
    if (overlay == OVERLAY_ERROR) return on_map ? e : vec3(0);
    return on_map ? e : calm_sun(place, depth);
}

vec3 ambient_at(float depth, vec3 sun) {
    if (!uneven) return vec3(s.ambient_r, s.ambient_g, s.ambient_b);
    vec3 a = diffuse_absorption();
    return vec3(
        ambient_on_floor(s.sky_r, sun.x, s.mean_r, s.r_ext, s.r_int, diffuse_passage(a.x, depth)),
        ambient_on_floor(s.sky_g, sun.y, s.mean_g, s.r_ext, s.r_int, diffuse_passage(a.y, depth)),
        ambient_on_floor(s.sky_b, sun.z, s.mean_b, s.r_ext, s.r_int, diffuse_passage(a.z, depth)));
}

// Diffuse light on a plane that sees so much of what comes down there, and the rest of what comes up. ambient_* is the
// one at the floor, up_* the other at the surface.
vec3 ambient_facing(float depth, float sky_part) {
    vec3 below = exp(-1.2 * diffuse_absorption() * (s.depth - depth)), above = exp(-1.2 * diffuse_absorption() * depth);
    return sky_part * vec3(s.ambient_r, s.ambient_g, s.ambient_b) / max(below, vec3(1e-6)) +
           (1 - sky_part) * vec3(s.up_r, s.up_g, s.up_b) / max(above, vec3(1e-6));
}

vec3 wall_inward(int wall) {
    return vec3(wall == 0 ? 1 : (wall == 1 ? -1 : 0), wall == 2 ? 1 : (wall == 3 ? -1 : 0), 0);
}

float along_wall(int wall, vec3 place) { return wall < 2 ? place.y - s.y0 : place.x - s.x0; }

vec3 sun_on_wall(int wall, vec3 place, float depth) {
    vec3 inward = wall_inward(wall);
    if (!wall_maps) return calm_sun(vec2(place), depth) * max(0, -(s.travel_x * inward.x + s.travel_y * inward.y));
    int columns = wall < 2 ? s.wall_columns_x : s.wall_columns_y;
    vec2 at = vec2(along_wall(wall, place) / (wall < 2 ? s.wall_pitch_x : s.wall_pitch_y),
                   (place.z + s.depth) / s.wall_pitch_up);
    at = clamp(at + 0.5, vec2(0.5), vec2(columns, s.wall_rows) + 0.499);
    int low = wall == 0 ? s.wall_offset_0 : s.wall_offset_1, high = wall == 2 ? s.wall_offset_2 : s.wall_offset_3;
    return light_at(wall < 2 ? low : high, columns + 2, at) * exp(-colours() * s.path * depth);
}

// A place in the water: on the floor or ground where `wall` is -1, else on a wall. Its pattern's coordinates, m.
vec2 on_pattern(int wall, vec3 place) { return wall < 0 ? vec2(place) : vec2(along_wall(wall, place), place.z); }

vec2 across_pattern(int wall, vec3 move) { return vec2(wall == 0 || wall == 1 ? move.y : move.x, wall < 0 ? move.y : move.z); }

// Widths of a pixel there.
vec2 widths_on_pattern(int wall, PerPixel moved) {
    vec2 a = across_pattern(wall, moved.right), b = across_pattern(wall, moved.up);
    return sqrt(a * a + b * b);
}

vec3 albedo_at(int wall, vec2 at, vec2 widths) {
    float side = wall < 0 ? s.floor_side : s.wall_side;
    float part = finish(floor_pattern, at, widths, side);
    if (wall_pattern != floor_pattern && (wall_x || wall_y))
        part = wall < 0 ? part : finish(wall_pattern, at, widths, side);
    return part * (wall < 0 ? vec3(s.floor_r, s.floor_g, s.floor_b) : vec3(s.wall_r, s.wall_g, s.wall_b));
}

// Its radiance towards any direction. `width` is that of the footprint, `widths` on the pattern, `open` the part of the
// diffuse light that nothing keeps off.
vec3 radiance_in_water(int wall, vec3 place, float width, vec2 widths, float open) {
    float depth = max(0, -place.z);
    if (shows_map()) {
        vec3 shown = overlay_colour(dot(sun_on_floor(vec2(place), depth, width), vec3(1.0 / 3)));
        if (wall < 0) return shown;
    }
    vec3 calm = uneven ? calm_sun(vec2(place), depth) : vec3(0);
    vec3 e = sun_on_floor(vec2(place), depth, width) + open * ambient_at(depth, calm);
    if (wall_x || wall_y) e = wall < 0 ? e : sun_on_wall(wall, place, depth) + open * ambient_facing(depth, 0.5);
    return albedo_at(wall, on_pattern(wall, place), widths) * e * (1 / pi);
}
