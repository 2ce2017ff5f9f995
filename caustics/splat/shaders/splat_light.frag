// The light of a splat in a pixel, W.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "sim/kernels/real.glsl"

#include "caustics/kernels/optics.glsl"
#include "caustics/kernels/splat.glsl"
#include "caustics/splat/shaders/splat_parameters.glsl"

layout(push_constant) uniform Push { SplatShift shift; };

// As splat_box.vert gives it.
layout(location = 0) flat in ivec2 pixel;
layout(location = 1) flat in vec4 place;
layout(location = 2) flat in vec4 shape;
layout(location = 3) flat in vec4 west;
layout(location = 4) flat in vec4 south;
layout(location = 5) flat in float west_inside;
layout(location = 0) out float power;

#include "caustics/splat/shaders/splat_share.glsl"

void main() {
    SplatRecord r = SplatRecord(pixel.x, pixel.y, place.x, place.y, place.z, shape.x, shape.y, shape.z, place.w, 0, 0, west.x,
                                west.y, west.z, west.w, west_inside, south.x, south.y, south.z, south.w, shape.w);
    vec2 corner = vec2(ivec2(gl_FragCoord.xy) - pixel) - (place.xy + vec2(shift.x, shift.y));
    power = r.power * splat_share(r, corner);
}
