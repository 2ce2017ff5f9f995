#version 460
// A letter's texel on each pixel, in its colour.
layout(std430, set = 0, binding = 2) readonly buffer Atlas { uint opacities[]; };
layout(push_constant) uniform Frame {
    vec2 size;
    ivec2 atlas_size;
};
layout(location = 0) in vec2 texel;
layout(location = 1) in vec4 colour;
layout(location = 0) out vec4 shown;

void main() {
    const ivec2 at = clamp(ivec2(texel), ivec2(0), atlas_size - 1);
    const int i = at.y * atlas_size.x + at.x;
    shown = vec4(colour.rgb, colour.a * unpackUnorm4x8(opacities[i / 4])[i % 4]);
}
