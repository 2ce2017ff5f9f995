// Half of what another target holds.
#version 460
#extension GL_EXT_samplerless_texture_functions : require

layout(binding = 1) uniform texture2D other;
layout(location = 0) flat in vec4 colour;
layout(location = 0) out vec4 drawn;

void main() {
    drawn = 0.5 * colour * texelFetch(other, ivec2(gl_FragCoord.xy), 0);
}
