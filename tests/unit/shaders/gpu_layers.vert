// Squares of one colour at one depth, as two triangles of a list each.
#version 460

layout(push_constant) uniform Push {
    int width;
    int height;
};
struct Layer {
    float x, y, side, depth;
    float r, g, b, a;
};
layout(std430, binding = 0) readonly buffer Layers { Layer layers[]; };
layout(location = 0) flat out vec4 colour;

const ivec2 corners[6] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};

void main() {
    Layer s = layers[gl_VertexIndex / 6];
    vec2 corner = vec2(s.x, s.y) + s.side * corners[gl_VertexIndex % 6];
    colour = vec4(s.r, s.g, s.b, s.a);
    gl_Position = vec4(2 * corner / vec2(width, height) - 1, s.depth, 1);
}
