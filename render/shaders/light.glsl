// Irradiance of floor, walls and ground below the water, of three colours: the sun's from the maps, or as under flat
// water where there are none, and the diffuse light's.

vec3 colours() { return vec3(s.colour_r, s.colour_g, s.colour_b); }

float light_at(int offset, int stride, vec2 place) {
    vec2 low = floor(place), w = place - low;
    int k = offset + int(low.y) * stride + int(low.x);
    return bilinear(light[k], light[k + 1], light[k + stride], light[k + stride + 1], w.x, w.y);
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

// `width` is the footprint's, m.
vec3 sun_on_floor(vec2 place, float depth, float width) {
    if (map_colours == 0) return calm_sun(place, depth);
    vec2 home = wrapped(place);
    vec2 pixel = vec2(s.map_x + home.x * s.map_xx + home.y * s.map_xy, s.map_y + home.x * s.map_yx + home.y * s.map_yy);
    int level = clamp(int(floor(log2(max(width / s.map_pitch, 1)) + 0.5)), 0, s.map_levels - 1);
    float scale = exp2(-float(level));
    ivec2 size = ivec2(ceil(vec2(s.map_width, s.map_height) * scale));
    vec2 at = clamp(pixel * scale + 0.5, vec2(0.5), vec2(size) + 0.499);
    int offset = s.map_offset[level], stride = size.x + 2;
    bool on_map = all(greaterThanEqual(pixel, vec2(-0.5))) &&
                  all(lessThanEqual(pixel, vec2(s.map_width, s.map_height) + 0.5));
    vec3 e;
    if (map_colours == 1) {
        e = light_at(offset, stride, at) * exp(-colours() * s.path * depth);
    } else {
        int plane = stride * (size.y + 2);
        e = vec3(light_at(offset, stride, at), light_at(offset + plane, stride, at),
                 light_at(offset + 2 * plane, stride, at));
    }
    return on_map ? e : calm_sun(place, depth);
}

vec3 ambient_at(float depth, vec3 sun) {
    if (!uneven) return vec3(s.ambient_r, s.ambient_g, s.ambient_b);
    vec3 a = diffuse_absorption();
    return vec3(
        ambient_on_floor(s.sky_r, sun.r, s.mean_r, s.r_ext, s.r_int, diffuse_passage(a.r, depth)),
        ambient_on_floor(s.sky_g, sun.g, s.mean_g, s.r_ext, s.r_int, diffuse_passage(a.g, depth)),
        ambient_on_floor(s.sky_b, sun.b, s.mean_b, s.r_ext, s.r_int, diffuse_passage(a.b, depth)));
}

// Radiance of a place on the floor, or on ground below the water.
vec3 floor_radiance(vec3 place, float width, vec2 widths) {
    float depth = max(0, -place.z);
    if (overlay == OVERLAY_FLOOR || overlay == OVERLAY_ERROR) return overlay_colour(dot(sun_on_floor(place.xy, 0, width), vec3(1.0 / 3)));
    vec3 calm = uneven ? calm_sun(place.xy, depth) : vec3(0);
    vec3 e = sun_on_floor(place.xy, depth, width) + ambient_at(depth, calm);
    vec3 albedo = vec3(s.floor_r, s.floor_g, s.floor_b) * finish(floor_pattern, place.xy, widths, s.floor_side);
    return albedo * e * (1 / pi);
}

// Diffuse light on a wall: half of what comes down and half of what comes up there.
vec3 ambient_on_wall(float depth) {
    vec3 passed = exp(-1.2 * diffuse_absorption() * (s.depth - depth));
    return 0.5 * (vec3(s.ambient_r, s.ambient_g, s.ambient_b) / max(passed, vec3(0.05)) +
                  vec3(s.up_r, s.up_g, s.up_b) * passed);
}

vec3 wall_inward(int wall) {
    return vec3(wall == 0 ? 1 : (wall == 1 ? -1 : 0), wall == 2 ? 1 : (wall == 3 ? -1 : 0), 0);
}

vec3 wall_radiance(int wall, vec3 place, vec2 widths) {
    float along = wall < 2 ? place.y - s.y0 : place.x - s.x0;
    float depth = max(0, -place.z);
    vec3 inward = wall_inward(wall);
    vec3 e;
    if (wall_maps) {
        int columns = s.wall_columns[wall], rows = s.wall_rows[wall];
        vec2 at = vec2(along / s.wall_pitch[wall], (place.z + s.depth) / s.wall_pitch_up[wall]);
        at = clamp(at + 0.5, vec2(0.5), vec2(columns, rows) + 0.499);
        e = light_at(s.wall_offset[wall], columns + 2, at) * exp(-colours() * s.path * depth);
    } else {
        float facing = max(0, -(s.travel_x * inward.x + s.travel_y * inward.y));
        e = calm_sun(place.xy, depth) * facing;
    }
    e += ambient_on_wall(depth);
    vec3 albedo = vec3(s.wall_r, s.wall_g, s.wall_b) * finish(wall_pattern, vec2(along, place.z), widths, s.wall_side);
    return albedo * e * (1 / pi);
}
