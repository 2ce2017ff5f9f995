// A strip of four corners for each square.
#version 460

layout(push_constant) uniform Push {
    int width;
    int height;
};
struct Square {
    float x, y, side, value;
};
layout(std430, binding = 0) readonly buffer Squares { Square squares[]; };
layout(location = 0) flat out float value;

void main() {
    Square s = squares[gl_InstanceIndex];
    vec2 corner = vec2(s.x, s.y) + s.side * vec2(gl_VertexIndex & 1, gl_VertexIndex >> 1);
    value = s.value;
    gl_Position = vec4(2 * corner / vec2(width, height) - 1, 0, 1);
}
