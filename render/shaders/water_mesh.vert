// A strip for each row of each copy of the water's mesh.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "render/shaders/includes.glsl"
#include "render/shaders/surface_cells.glsl"

void main() {
    int copy = gl_InstanceIndex / p.rows, row = gl_InstanceIndex - copy * p.rows + (gl_VertexIndex & 1);
    vec2 part = vec2(gl_VertexIndex >> 1, row) / vec2(p.columns, p.rows);
    vec2 u = mix(vec2(p.u0, p.v0), vec2(p.u1, p.v1), part);
    vec4 shift = copies[p.first_copy + copy];
    gl_Position = seen(vec3(s.x0 + u.x * s.cell_x, s.y0 + u.y * s.cell_y, elevation_at(cells_around(u))) + shift.xyz);
}
