// Vertices on the water's surface: light enters there and lands. Each invocation also sums the account of the vertices
// it lands.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "sim/kernels/real.glsl"

#include "caustics/kernels/optics.glsl"
#include "caustics/kernels/splat.glsl"
#include "caustics/kernels/surface_lookup.glsl"
#include "caustics/splat/shaders/splat_parameters.glsl"

layout(local_size_x_id = 0, local_size_y_id = 1, local_size_z_id = 2) in;

layout(std430, binding = 0) readonly buffer Parameters { SplatParameters p; };
layout(std430, binding = 1) readonly buffer Places { SplatPlace places[]; };  // of the columns, then of the rows
layout(std430, binding = 2) readonly buffer Elevation { float elevations[]; };
layout(std430, binding = 3) readonly buffer SlopeX { float slopes_x[]; };
layout(std430, binding = 4) readonly buffer SlopeY { float slopes_y[]; };
layout(std430, binding = 5) readonly buffer Heights { float heights[]; };
layout(std430, binding = 6) writeonly buffer Landings { SplatLanding landings[]; };
layout(std430, binding = 7) writeonly buffer Accounts { SplatAccount accounts[]; };

#include "caustics/splat/shaders/splat_landing.glsl"

real blend(vec4 around, AxisPlace x, AxisPlace y) {
    return x.water * y.water * bilinear(around[0], around[1], around[2], around[3], x.weight, y.weight);
}

// Beyond a wall the places are those of the mirrored water, and slopes along the axis change their sign.
float mirror(int vertex, int count, int side) {
    return side == SIDE_WALL && (vertex < 0 || vertex >= count) ? -1.0 : 1.0;
}

SplatLanding land(int i, int j, inout SplatAccount account) {
    SplatPlace c = places[i];
    SplatPlace r = places[p.columns + j];
    int side_x = p.sides & 3;
    int side_y = p.sides >> 2;
    AxisPlace x = place_on_axis(c.cell, c.cell_part, p.nx, side_x, p.half_width_x);
    AxisPlace y = place_on_axis(r.cell, r.cell_part, p.ny, side_y, p.half_width_y);
    ivec4 cells = ivec4(x.low, x.high, x.low, x.high) + p.nx * ivec4(y.low, y.low, y.high, y.high);
    vec4 mirror_x = vec4(x.mirror_low, x.mirror_high, x.mirror_low, x.mirror_high);
    vec4 mirror_y = vec4(y.mirror_low, y.mirror_low, y.mirror_high, y.mirror_high);
#define AROUND(field) vec4(field[cells[0]], field[cells[1]], field[cells[2]], field[cells[3]])
    ivec2 vertex = ivec2(p.first_x + i, p.first_y + j);
    float elevation = blend(AROUND(elevations), x, y) + p.climb_x * wraps_between(x) + p.climb_y * wraps_between(y);
    vec2 slope = vec2(mirror(vertex.x, p.domain_x, side_x) * blend(mirror_x * AROUND(slopes_x), x, y),
                      mirror(vertex.y, p.domain_y, side_y) * blend(mirror_y * AROUND(slopes_y), x, y));
    vec3 start = vec3(c.at, r.at, elevation);
    WaterVertex v = enter_water(light(), start, slope, p.index, p.fresnel);

    bool dark = min(min(i, p.columns - 1 - i), min(j, p.rows - 1 - j)) < p.rim;
    bool own = vertex.x >= 0 && vertex.x < p.domain_x && vertex.y >= 0 && vertex.y < p.domain_y;
    float lit = dark ? 0 : p.area * lit_part(x, side_x) * lit_part(y, side_y);
    account.incident += own ? lit * v.incident : 0;
    account.reflected += own ? lit * (v.incident - v.transmitted) : 0;
    return land_from(start, v.direction, lit * v.transmitted, p.extinction, own,
                     ivec2(c.pixel_x + r.pixel_x, c.pixel_y + r.pixel_y), vec2(c.part_x + r.part_x, c.part_y + r.part_y),
                     account);
}

void main() {
    int chunk = int(gl_WorkGroupID.y);
    int me = int(gl_LocalInvocationID.x);
    int workers = int(gl_WorkGroupSize.x);
    int end = min(p.count, (chunk + 1) * splat_chunk);
    SplatAccount account = SplatAccount(0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
    for (int k = chunk * splat_chunk + me; k < end; k += workers)
        landings[k] = land(k % p.columns, k / p.columns, account);
    accounts[chunk * workers + me] = account;
}
