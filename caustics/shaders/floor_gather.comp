// Pass 1 (paper, figure 5): each pixel column, on each row of samples, asks N samples along x how much of them it
// gets, and in which of the M + 1 rows around. A sample's box touches two rows, so two channels take it.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "sim/kernels/real.glsl"

#include "caustics/kernels/optics.glsl"
#include "caustics/kernels/floor.glsl"
#include "caustics/shaders/floor_parameters.glsl"

layout(local_size_x_id = 0, local_size_y_id = 1, local_size_z_id = 2) in;

layout(push_constant) uniform Push { FloorParameters f; };
// Channel by channel: the rows of the band, map_width wide.
layout(std430, binding = 0) buffer Channels { float channels[]; };
layout(binding = 1) uniform samplerBuffer landed_texels;

float landed(int at) { return texelFetch(landed_texels, at).x; }

int slot(int channel, int row, int x) {
    return ((channel + f.half_channels) * f.band_count + row) * f.map_width + x;
}

void add(int channel, int row, int x, real light) {
    if (abs(channel) <= f.half_channels) channels[slot(channel, row, x)] += light;
}

void main() {
    int x = int(gl_GlobalInvocationID.x);
    int row = int(gl_GlobalInvocationID.y);
    if (x >= f.map_width || row >= f.band_count) return;
    for (int channel = -f.half_channels; channel <= f.half_channels; ++channel) channels[slot(channel, row, x)] = 0;

    int band_size = f.band_count * f.column_count;
    int first = max(x - f.half_samples, f.first_column);
    int last = min(x + f.half_samples, f.first_column + f.column_count - 1);
    for (int base = first; base <= last; ++base) {
        int at = row * f.column_count + base - f.first_column;
        real along_x = pixel_overlap(landed(at) - real(x - base));
        if (!(along_x > 0)) continue;
        real y = landed(at + band_size);
        if (!(abs(y) <= real(f.half_channels + 1))) continue;
        real light = along_x * landed(at + 2 * band_size);
        int low = int(floor(y));
        add(low, row, x, light * pixel_overlap(y - real(low)));
        add(low + 1, row, x, light * pixel_overlap(y - real(low + 1)));
    }
}
