// Pass 1 with the adaptive footprint: each pixel column, on each row of samples, asks N samples along x how much of
// their parallelograms it gets, and in which of the M + 1 rows around.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "sim/kernels/real.glsl"

#include "caustics/kernels/footprint.glsl"
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

// Adds what lies of a strip in the column about `column`, row by row.
void add_strip(Strip s, real light, real column, int row, int x) {
    if (!(abs(column - s.centre.x) < real(0.5) * (real(1) + s.width + abs(s.slant)))) return;
    real half_rows = real(f.half_channels);
    int low = int(floor(clamp(s.centre.y - real(0.5) * s.height, -half_rows, half_rows + 1) + real(0.5)));
    int high = int(floor(clamp(s.centre.y + real(0.5) * s.height, -half_rows - 1, half_rows) + real(0.5)));
    for (int channel = low; channel <= high; ++channel) {
        StripPart p = strip_between(s, real(channel) - real(0.5), real(channel) + real(0.5));
        real share = part_below(p, column + real(0.5)) - part_below(p, column - real(0.5));
        if (p.part * share > 0) channels[slot(channel, row, x)] += light * p.part * share;
    }
}

void main() {
    int x = int(gl_GlobalInvocationID.x);
    int row = int(gl_GlobalInvocationID.y);
    if (x >= f.map_width || row >= f.band_count) return;
    for (int channel = -f.half_channels; channel <= f.half_channels; ++channel) channels[slot(channel, row, x)] = 0;

    int band_size = f.band_count * f.column_count;
    int first = max(x - f.half_samples, f.first_column);
    int last = min(x + f.half_samples, f.first_column + f.column_count - 1);
    int strips = f.options >> 3;
    for (int base = first; base <= last; ++base) {
        int at = row * f.column_count + base - f.first_column;
        Parallelogram shape = Parallelogram(landed(at + 3 * band_size), landed(at + 4 * band_size),
                                            landed(at + 5 * band_size), landed(at + 6 * band_size));
        real2 centre = real2(landed(at), landed(at + band_size));
        real light = landed(at + 2 * band_size) / real(strips);
        for (int k = 0; k < strips; ++k)
            add_strip(strip_of(shape, centre, real(k), real(strips)), light, real(x - base), row, x);
    }
}
