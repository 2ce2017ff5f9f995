// The light of a splat in a pixel, W.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "sim/kernels/real.glsl"

#include "caustics/kernels/optics.glsl"
#include "caustics/kernels/splat.glsl"
#include "caustics/splat/shaders/splat_parameters.glsl"

layout(push_constant) uniform Push { SplatShift shift; };
layout(std430, binding = 0) readonly buffer Records { SplatRecord records[]; };

layout(location = 0) flat in int splat;
layout(location = 0) out float power;

#include "caustics/splat/shaders/splat_share.glsl"

void main() {
    SplatRecord r = records[splat];
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 corner = vec2(pixel.x - r.pixel_x, pixel.y - r.pixel_y) - (vec2(r.part_x, r.part_y) + vec2(shift.x, shift.y));
    power = r.power * splat_share(r, corner);
}
