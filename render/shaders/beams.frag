// Light of beams, added.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "render/shaders/includes.glsl"
#include "render/shaders/light.glsl"
#include "render/shaders/water.glsl"

layout(binding = 7) uniform samplerBuffer beam_texels;

float beam_value(int k) { return texelFetch(beam_texels, k).x; }
layout(location = 0) out vec4 drawn;

#include "render/shaders/beam_light.glsl"

void main() {
    Sight a = sight(gl_FragCoord.xy);
    drawn = vec4(exposed(beam_light(gl_FragCoord.xy) * beam_tint(a)).rgb, 0);
}
