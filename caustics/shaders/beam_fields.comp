// Fills fields with the light of beams: each beam's section at each depth is shared exactly among the cells that it
// overlaps. Sums are whole numbers of 64 bits in two halves, so that they do not depend on the order in which beams
// come. One invocation a beam and group of slices.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "sim/kernels/real.glsl"

#include "caustics/kernels/cell_share.glsl"
#include "caustics/kernels/optics.glsl"
#include "caustics/shaders/beam_field_parameters.glsl"

layout(local_size_x_id = 0, local_size_y_id = 1, local_size_z_id = 2) in;

layout(push_constant) uniform Push { BeamFieldParameters p; };
// x, y, z, travel_x, travel_y, path and end_z of all corners, one after another.
layout(std430, binding = 0) readonly buffer Corners { float corners[]; };
layout(std430, binding = 1) readonly buffer Flux { float flux[]; };
// Of each cell: flux through the horizontal, low half and high, and through planes that face the light. After those, of
// each slice and row of beams: flux, and what of it left through the sides.
layout(std430, binding = 2) buffer Sums { uint sums[]; };

const int slices_each = 8;
const int most_corners = 5;  // of a triangle cut twice

struct Corner {
    vec2 place;     // at still water, in cells
    vec2 travel;    // cells per metre of descent
    float z;
    float path;
    float end_z;
};

Corner at[3];

// A corner of a section, and how far above it the light entered the water and below it ends.
struct Corner2 {
    vec2 place;
    vec2 part;  // of the ways from the triangle's first corner to its second and third
    vec2 level;
};

Corner2 polygon[most_corners];
int count;

Corner read_corner(int i, int j) {
    int n = (p.nx + 1) * (p.ny + 1), k = j * (p.nx + 1) + i;
    vec2 per_metre = vec2(p.per_metre_x, p.per_metre_y);
    Corner c;
    c.z = corners[2 * n + k];
    c.place = vec2(corners[k], corners[n + k]) - vec2(p.x0, p.y0);
    c.travel = vec2(corners[3 * n + k], corners[4 * n + k]);
    c.place *= per_metre;
    c.travel *= per_metre;
    c.path = corners[5 * n + k];
    c.end_z = corners[6 * n + k];
    return c;
}

void read_beam(int b, int j) {
    int i = b >> 1;
    bool upper = (b & 1) == 1;
    at[0] = read_corner(i, j);
    at[1] = read_corner(i + 1, upper ? j + 1 : j);
    at[2] = read_corner(upper ? i : i + 1, j + 1);
}

// Keeps the part of the polygon where a level is not below zero.
void keep_positive(int level) {
    Corner2 kept[most_corners];
    int n = 0;
    for (int k = 0; k < count; ++k) {
        Corner2 a = polygon[k], b = polygon[k + 1 == count ? 0 : k + 1];
        float here = a.level[level], next = b.level[level];
        if (here >= 0) kept[n++] = a;
        if ((here > 0 && next < 0) || (here < 0 && next > 0)) {
            float part = here / (here - next);
            kept[n++] = Corner2(mix(a.place, b.place, part), mix(a.part, b.part, part), mix(a.level, b.level, part));
        }
    }
    polygon = kept;
    count = n;
}

float cross2(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// Twice the signed area.
float twice_area() {
    float twice = 0;
    for (int k = 1; k + 1 < count; ++k)
        twice += cross2(polygon[k].place - polygon[0].place, polygon[k + 1].place - polygon[0].place);
    return twice;
}

float share_of_triangle() {
    float twice = 0;
    for (int k = 1; k + 1 < count; ++k)
        twice += cross2(polygon[k].part - polygon[0].part, polygon[k + 1].part - polygon[0].part);
    return abs(twice);
}

// The section at z; returns the part of the beam's light that passes through it.
float cut_section(float z) {
    const vec2 parts[3] = vec2[](vec2(0, 0), vec2(1, 0), vec2(0, 1));
    float remaining = 0;
    bool all = true;
    for (int k = 0; k < 3; ++k) {
        float descent = max(0, at[k].z - z);
        polygon[k] = Corner2(at[k].place + descent * at[k].travel, parts[k], vec2(at[k].z - z, z - at[k].end_z));
        remaining += beer_lambert(p.extinction, descent * at[k].path) / 3;
        all = all && polygon[k].level.x >= 0 && polygon[k].level.y >= 0;
    }
    count = 3;
    if (all) return remaining;
    keep_positive(0);
    keep_positive(1);
    return count < 3 ? 0 : remaining * share_of_triangle();
}

// A number of 64 bits, low half first.
uvec2 whole(float quanta) {
    float high = floor(quanta * 2.3283064365386963e-10);  // 2^-32
    return uvec2(uint(quanta - high * 4294967296.0), uint(high));
}

uvec2 plus(uvec2 a, uvec2 b) {
    uint carry;
    uint low = uaddCarry(a.x, b.x, carry);
    return uvec2(low, a.y + b.y + carry);
}

uvec2 minus(uvec2 a, uvec2 b) {
    uint borrow;
    uint low = usubBorrow(a.x, b.x, borrow);
    return uvec2(low, a.y - b.y - borrow);
}

uvec2 lesser(uvec2 a, uvec2 b) { return a.y < b.y || (a.y == b.y && a.x < b.x) ? a : b; }

void add_to_sum(int k, uvec2 n) {
    uint before = atomicAdd(sums[k], n.x);
    uint high = n.y + (before + n.x < before ? 1 : 0);
    if (high > 0) atomicAdd(sums[k + 1], high);
}

int wrapped(int i, int n) { return i - n * int(floor(float(i) / float(n))); }

// Adds light to a cell of the slice; returns what is beyond a side.
uvec2 put(ivec2 cell, int slice, uvec2 quanta, float facing) {
    if (p.periodic_x == 1) cell.x = wrapped(cell.x, p.columns);
    if (p.periodic_y == 1) cell.y = wrapped(cell.y, p.rows);
    if (cell.x < 0 || cell.x >= p.columns || cell.y < 0 || cell.y >= p.rows) return quanta;
    int k = 4 * ((slice * p.rows + cell.y) * p.columns + cell.x);
    add_to_sum(k, quanta);
    add_to_sum(k + 2, whole(facing));
    return uvec2(0);
}

// Shares the section's light among the cells that it overlaps, to the last quantum; returns what is beyond the sides.
uvec2 share(int slice, float quanta, float path) {
    vec2 low = polygon[0].place, high = low, sum = low;
    for (int k = 1; k < count; ++k) {
        low = min(low, polygon[k].place);
        high = max(high, polygon[k].place);
        sum += polygon[k].place;
    }
    ivec2 first = ivec2(floor(low)), last = ivec2(floor(high));
    uvec2 left = whole(quanta), outside = uvec2(0);
    if (first == last) return put(first, slice, left, quanta * path);
    float area = 0.5 * twice_area(), part_left = 1;
    // Thinner than that, shares would be rounding: all goes to the cell of its middle.
    for (int j = first.y; j <= last.y && abs(area) > 1e-6; ++j)
        for (int i = first.x; i <= last.x; ++i) {
            float covered = 0;
            for (int k = 0; k < count; ++k)
                covered -= area_right_of(polygon[k].place - vec2(i, j),
                                         polygon[k + 1 == count ? 0 : k + 1].place - vec2(i, j));
            float part = min(covered / area, part_left);
            if (part <= 0) continue;
            part_left -= part;
            uvec2 taken = lesser(whole(part * quanta), left);
            left = minus(left, taken);
            outside = plus(outside, put(ivec2(i, j), slice, taken, part * quanta * path));
        }
    return plus(outside, put(ivec2(floor(sum / count)), slice, left, part_left * quanta * path));
}

void main() {
    int b = int(gl_GlobalInvocationID.x), j = int(gl_GlobalInvocationID.y);
    int first = slices_each * int(gl_GlobalInvocationID.z);
    if (b >= 2 * p.nx || j >= p.ny) return;
    float entering = flux[2 * p.nx * j + b];
    if (!(entering > 0)) return;
    read_beam(b, j);
    float path = (at[0].path + at[1].path + at[2].path) / 3;
    int ledger = 4 * p.columns * p.rows * p.slice_count;
    for (int slice = first; slice < min(first + slices_each, p.slice_count); ++slice) {
        float z = ((p.first_slice + slice + 0.5) / p.slices - 1) * p.depth;
        float quanta = entering * p.per_quantum * cut_section(z);
        if (!(quanta > 0)) continue;
        int k = ledger + 4 * (slice * p.ny + j);
        add_to_sum(k, whole(quanta));
        uvec2 outside = share(slice, quanta, path);
        if (outside != uvec2(0)) add_to_sum(k + 2, outside);
    }
}
