#version 460
// Corners of an interface's triangles, pulled by their indices.
struct Corner {
    float x, y, u, v;
    uint rgba;
};
layout(std430, set = 0, binding = 0) readonly buffer Corners { Corner corners[]; };
layout(std430, set = 0, binding = 1) readonly buffer Indices { uint indices[]; };
layout(push_constant) uniform Frame {
    vec2 size;
    ivec2 atlas_size;
};
layout(location = 0) out vec2 texel;
layout(location = 1) out vec4 colour;

void main() {
    const Corner corner = corners[indices[gl_VertexIndex]];
    gl_Position = vec4(2 * vec2(corner.x, corner.y) / size - 1, 0, 1);
    texel = vec2(corner.u, corner.v) * atlas_size;
    colour = unpackUnorm4x8(corner.rgba);
}
