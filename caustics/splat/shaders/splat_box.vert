// Pulls a corner of the box about a splat; splats without light, or beside the map, are drawn nowhere.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "caustics/splat/shaders/splat_parameters.glsl"

layout(push_constant) uniform Push { SplatShift shift; };
layout(std430, binding = 0) readonly buffer Records { SplatRecord records[]; };

layout(location = 0) flat out int splat;

void main() {
    SplatRecord r = records[gl_InstanceIndex];
    splat = gl_InstanceIndex;
    vec2 size = vec2(shift.width, shift.height);
    vec2 centre = vec2(r.pixel_x, r.pixel_y) + vec2(r.part_x, r.part_y) + vec2(shift.x, shift.y);
    vec2 reach = vec2(r.reach_x, r.reach_y);
    // Whole pixels.
    vec2 low = max(floor(centre - reach), vec2(0));
    vec2 high = min(floor(centre + reach) + 1, size);
    vec2 corner = mix(low, high, vec2(gl_VertexIndex & 1, gl_VertexIndex >> 1));
    bool drawn = r.power > 0 && low.x < high.x && low.y < high.y;
    gl_Position = drawn ? vec4(2 * corner / size - 1, 0, 1) : vec4(2, 2, 0, 1);
}
