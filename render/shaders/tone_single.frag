// The picture for a screen, of radiance with one sample a pixel: tone curve and sRGB.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require

#include "sim/kernels/real.glsl"

#include "render/kernels/tone.glsl"

layout(binding = 1) uniform texture2D radiance;
layout(location = 0) out vec4 drawn;

float shown(float x) { return srgb_encoded(filmic(x)); }

void main() {
    vec3 x = texelFetch(radiance, ivec2(gl_FragCoord.xy), 0).rgb;
    drawn = vec4(shown(x.r), shown(x.g), shown(x.b), 1);
}
