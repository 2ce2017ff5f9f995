// The picture for a screen: samples averaged as radiance, then tone curve and sRGB.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require

#include "sim/kernels/real.glsl"

#include "render/kernels/tone.glsl"

layout(constant_id = 0) const int samples = 1;

layout(binding = 1) uniform texture2DMS radiance;
layout(location = 0) out vec4 drawn;

float shown(float x) { return srgb_encoded(filmic(x)); }

void main() {
    vec3 sum = vec3(0);
    for (int k = 0; k < samples; ++k) sum += texelFetch(radiance, ivec2(gl_FragCoord.xy), k).rgb;
    vec3 x = sum / samples;
    drawn = vec4(shown(x.r), shown(x.g), shown(x.b), 1);
}
