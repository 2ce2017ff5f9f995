// Pulls a corner of the box about a splat; splats without light, or beside the map, are drawn nowhere.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "caustics/splat/shaders/splat_parameters.glsl"

layout(push_constant) uniform Push { SplatShift shift; };
layout(std430, binding = 0) readonly buffer Records { SplatRecord records[]; };

// What of its record the light of a splat needs.
layout(location = 0) flat out ivec2 pixel;
layout(location = 1) flat out vec4 place;  // part of the pixel; power; transposed
layout(location = 2) flat out vec4 shape;  // along, across, lean; south_inside
layout(location = 3) flat out vec4 west;   // point, normal
layout(location = 4) flat out vec4 south;
layout(location = 5) flat out float west_inside;

void main() {
    SplatRecord r = records[gl_InstanceIndex];
    pixel = ivec2(r.pixel_x, r.pixel_y);
    place = vec4(r.part_x, r.part_y, r.power, r.transposed);
    shape = vec4(r.along, r.across, r.lean, r.south_inside);
    west = vec4(r.west_x, r.west_y, r.west_normal_x, r.west_normal_y);
    south = vec4(r.south_x, r.south_y, r.south_normal_x, r.south_normal_y);
    west_inside = r.west_inside;
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
