// Pass 2 (paper, figure 6): each pixel takes from the rows of samples around it the channel that stands for it. Rows
// beyond the band add theirs in their turn.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "caustics/shaders/floor_parameters.glsl"

layout(local_size_x_id = 0, local_size_y_id = 1, local_size_z_id = 2) in;

layout(push_constant) uniform Push { FloorParameters f; };
layout(std430, binding = 0) buffer Map { float map[]; };
layout(binding = 1) uniform samplerBuffer channels;

void main() {
    int first_base = f.first_row + f.band_begin;
    int x = int(gl_GlobalInvocationID.x);
    int y = int(gl_GlobalInvocationID.y) + first_base - f.half_channels;
    if (x >= f.map_width || y < 0 || y >= f.map_height) return;

    int lowest = max(-f.half_channels, y - first_base - f.band_count + 1);
    int highest = min(f.half_channels, y - first_base);
    float sum = 0;
    for (int channel = lowest; channel <= highest; ++channel) {
        int row = y - channel - first_base;
        sum += texelFetch(channels, ((channel + f.half_channels) * f.band_count + row) * f.map_width + x).x;
    }
    if (lowest <= highest) map[y * f.map_width + x] += sum;
}
