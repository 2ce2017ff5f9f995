// Pulls a corner of a cell's outline, and hands the cell's numbers on.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "caustics/shaders/beam_image_parameters.glsl"
#include "caustics/shaders/beam_cell_record.glsl"

layout(push_constant) uniform Push { BeamPixelParameters p; };
layout(std430, binding = 0) readonly buffer Cells { CellRecord cells[]; };

layout(location = 0) flat out vec4 edge[4];
layout(location = 4) flat out vec4 mean;
layout(location = 5) flat out vec4 power;
layout(location = 6) flat out vec4 top[2];
layout(location = 8) flat out vec4 ground[2];

void main() {
    vec4 pair = cells[gl_InstanceIndex].outline[gl_VertexIndex >> 1];
    vec2 corner = (gl_VertexIndex & 1) == 0 ? pair.xy : pair.zw;
    // Pixel centres are at whole numbers.
    gl_Position = vec4(2 * (corner + 0.5) / vec2(p.width, p.height) - 1, 0, 1);
    edge = cells[gl_InstanceIndex].edge;
    mean = cells[gl_InstanceIndex].mean;
    power = cells[gl_InstanceIndex].power;
    top = cells[gl_InstanceIndex].top;
    ground = cells[gl_InstanceIndex].ground;
}
