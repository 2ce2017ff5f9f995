// A strip for each row of each copy of the ground's mesh. Beyond the grid it is as high as at its edge.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "render/shaders/includes.glsl"

void main() {
    int copy = gl_InstanceIndex / p.rows, row = gl_InstanceIndex - copy * p.rows + (gl_VertexIndex & 1);
    vec2 part = vec2(gl_VertexIndex >> 1, row) / vec2(p.columns, p.rows);
    vec2 u = mix(vec2(p.u0, p.v0), vec2(p.u1, p.v1), part);
    vec2 place = vec2(s.x0, s.y0) + u * vec2(s.cell_x, s.cell_y);
    gl_Position = seen(vec3(place + copies[p.first_copy + copy].xy, ground_around(u).height));
}
