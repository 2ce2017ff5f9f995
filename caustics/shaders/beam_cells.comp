// Views the cells of a grid of beams: a convex outline in the picture, and the numbers that its rays need. One
// invocation a cell.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "sim/kernels/real.glsl"

#include "caustics/kernels/beams.glsl"
#include "caustics/shaders/beam_image_parameters.glsl"
#include "caustics/shaders/beam_cell_record.glsl"

layout(local_size_x_id = 0, local_size_y_id = 1, local_size_z_id = 2) in;

layout(push_constant) uniform Push { BeamCellParameters p; };
// x, y, z, travel_x, travel_y, path and end_z of all corners, one after another.
layout(std430, binding = 0) readonly buffer Corners { float corners[]; };
layout(std430, binding = 1) readonly buffer Flux { float flux[]; };
layout(std430, binding = 2) writeonly buffer Cells { CellRecord cells[]; };
layout(std430, binding = 3) buffer Counts { uint beams_shown; };

const float nearest_m = 1e-3;
const float slack = 0.01;   // pixels by which an outline is wider, for rounding
const float hidden = -1e4;  // pixels, beyond every picture

vec3 top[4], end[4];
vec2 travel[4];
float path;

void read_corners(int i, int j) {
    int columns = p.nx + 1, count = columns * (p.ny + 1);
    int at[4] = int[](j * columns + i, j * columns + i + 1, (j + 1) * columns + i + 1, (j + 1) * columns + i);
    vec3 eye = vec3(p.eye_x, p.eye_y, p.eye_z);
    path = 0;
    for (int k = 0; k < 4; ++k) {
        vec3 corner = vec3(corners[at[k]] + p.shift_x, corners[count + at[k]] + p.shift_y, corners[2 * count + at[k]]);
        travel[k] = vec2(corners[3 * count + at[k]], corners[4 * count + at[k]]);
        path += 0.25 * corners[5 * count + at[k]];
        float descent = max(0, corner.z - corners[6 * count + at[k]]);
        top[k] = corner - eye;
        end[k] = top[k] + descent * vec3(travel[k], -1);
    }
}

bool in_range() {
    vec3 low = min(top[0], end[0]), high = max(top[0], end[0]);
    for (int k = 1; k < 4; ++k) {
        low = min(low, min(top[k], end[k]));
        high = max(high, max(top[k], end[k]));
    }
    vec3 nearest = clamp(vec3(0), low, high);
    return dot(nearest, nearest) <= p.range * p.range;
}

vec2 project(vec3 place, float ahead) {
    vec3 right = vec3(p.right_x, p.right_y, p.right_z), up = vec3(p.up_x, p.up_y, p.up_z);
    vec3 away = place / ahead - vec3(p.corner_x, p.corner_y, p.corner_z);
    return vec2(dot(away, right) / dot(right, right), dot(away, up) / dot(up, up));
}

vec2 shadow[8], low, high;

void hold(vec2 place) {
    low = min(low, place);
    high = max(high, place);
}

// Projects the corners; returns how many lie ahead. What is behind the camera is cut off: then only the bounds hold.
int project_corners() {
    vec3 forward = vec3(p.forward_x, p.forward_y, p.forward_z);
    vec3 place[8];
    float ahead[8];
    int seen = 0;
    low = vec2(1e30);
    high = vec2(-1e30);
    for (int k = 0; k < 8; ++k) {
        place[k] = k < 4 ? top[k] : end[k - 4];
        ahead[k] = dot(place[k], forward);
        if (ahead[k] < nearest_m) continue;
        shadow[seen++] = project(place[k], ahead[k]);
        hold(shadow[seen - 1]);
    }
    if (seen == 8) return seen;
    for (int a = 0; a < 8; ++a)
        for (int b = 0; b < 8; ++b)
            if (ahead[a] >= nearest_m && ahead[b] < nearest_m) {
                float part = (ahead[a] - nearest_m) / (ahead[a] - ahead[b]);
                hold(project(place[a] + part * (place[b] - place[a]), nearest_m));
            }
    return seen;
}

float cross2(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

vec2 hull[16];

// The convex hull of the eight corners, counter-clockwise (Andrew's monotone chain); returns how many it has.
int enclose() {
    for (int i = 1; i < 8; ++i) {
        vec2 held = shadow[i];
        int k = i - 1;
        for (; k >= 0; --k) {
            if (shadow[k].x < held.x || (shadow[k].x == held.x && shadow[k].y <= held.y)) break;
            shadow[k + 1] = shadow[k];
        }
        shadow[k + 1] = held;
    }
    int count = 0, least = 2;
    for (int step = 0; step < 15; ++step) {
        if (step == 8) least = count + 1;
        vec2 next = shadow[step < 8 ? step : 14 - step];
        while (count >= least && cross2(hull[count - 1] - hull[count - 2], next - hull[count - 2]) <= 0) --count;
        hull[count++] = next;
    }
    return count - 1;
}

// Moves the sides of the hull outwards; where they meet at less than 29 degrees the corner moves by no more than four
// times as much.
vec2 widened(int k, int count) {
    vec2 before = normalize(hull[k] - hull[(k + count - 1) % count]), after = normalize(hull[(k + 1) % count] - hull[k]);
    vec2 outward = vec2(before.y + after.y, -before.x - after.x) / max(1 + dot(before, after), 1e-6);
    return hull[k] + slack * outward * min(1, 4 / length(outward));
}

void write_outline(int cell, bool shown, bool whole) {
    vec2 strip[8];
    int count = shown && whole ? enclose() : 0;
    for (int v = 0; v < 8; ++v) {
        // Left and right in turn; what is over repeats the last.
        int held = min(v, count - 1);
        if (count >= 3) strip[v] = widened((held & 1) == 1 ? (held + 1) / 2 : (count - held / 2) % count, count);
    }
    if (count < 3) {
        vec2 size = vec2(p.width, p.height);
        vec2 from = shown ? clamp(low - slack, vec2(-1), size) : vec2(hidden);
        vec2 to = shown ? clamp(high + slack, vec2(-1), size) : vec2(hidden);
        for (int v = 0; v < 8; ++v) strip[v] = vec2((v & 1) == 0 ? from.x : to.x, v < 2 ? from.y : to.y);
    }
    for (int k = 0; k < 4; ++k) cells[cell].outline[k] = vec4(strip[2 * k], strip[2 * k + 1]);
}

void write_numbers(int cell, vec2 power) {
    vec2 mean = 0.25 * (travel[0] + travel[1] + travel[2] + travel[3]);
    float above = 0.25 * (top[0].z + top[1].z + top[2].z + top[3].z);
    for (int k = 0; k < 4; ++k) {
        BeamEdge edge = beam_edge(top[k], travel[k]);
        cells[cell].edge[k] = vec4(edge.at, edge.travel - mean);
    }
    cells[cell].mean = vec4(mean, path, above);
    cells[cell].power = vec4(2 * p.scattering * path * power, -min(min(top[0].z, top[1].z), min(top[2].z, top[3].z)),
                             -max(max(end[0].z, end[1].z), max(end[2].z, end[3].z)));
    for (int beam = 0; beam < 2; ++beam) {
        bool lit = power[beam] > 0;
        BeamLid upper = upper_lid(top[0], top[1 + beam], top[2 + beam]);
        BeamLid lower = lower_lid(end[0], end[1 + beam], end[2 + beam], vec3(mean, -1));
        cells[cell].top[beam] = lit ? vec4(upper.outward, upper.distance) : vec4(0);
        cells[cell].ground[beam] = lit ? vec4(lower.outward, lower.distance) : vec4(0);
    }
}

// Whether the bounds hold the centre of any pixel column, and of rows that may be.
bool in_picture() {
    vec2 last = vec2(p.width - 1, p.height - 1);
    return all(greaterThanEqual(high + slack, vec2(0))) && all(lessThanEqual(low - slack, last)) &&
           ceil(max(low.x - slack, 0)) <= floor(min(high.x + slack, last.x));
}

void main() {
    int i = int(gl_GlobalInvocationID.x), j = int(gl_GlobalInvocationID.y);
    if (i >= p.nx || j >= p.ny) return;
    int cell = j * p.nx + i;
    vec2 power = vec2(flux[2 * cell], flux[2 * cell + 1]);
    bool shown = power.x + power.y > 0;
    bool whole = false;
    if (shown) {
        read_corners(i, j);
        shown = in_range();
    }
    if (shown) {
        whole = project_corners() == 8;
        shown = in_picture();
    }
    write_outline(cell, shown, whole);
    if (!shown) return;
    write_numbers(cell, power);
    atomicAdd(beams_shown, 2);
}
