// What the fluxes make of every cell: `change` after the first stage, `now` after the second; a look leaves the state as
// it is. After all but the first stage the discharge of films is settled and the fastest waves are found. Numbers are
// precise where a cell and its neighbour must come to the same one, or where a carry would be simplified away.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "sim/shaders/shallow_fields.glsl"

shared uint fastest;

// The part of its outflow that a cell can give; all of it beyond the sides.
real drain(int i, int j) {
    if (p.periodic_x != 0) i = i < 0 ? p.nx - 1 : i == p.nx ? 0 : i;
    if (p.periodic_y != 0) j = j < 0 ? p.ny - 1 : j == p.ny ? 0 : j;
    if (i < 0 || i >= p.nx || j < 0 || j >= p.ny) return 1;
    int k = at(i, j);
    precise real first_depth = start[k].y + now[k].x;
    real h = p.stage == 2 ? change[k].w : first_depth;
    real low_x = min(flux_x[k].x, 0);
    real high_x = max(flux_x[at(i + 1, j)].x, 0);
    real low_y = min(flux_y[k].x, 0);
    real high_y = max(flux_y[at(i, j + 1)].x, 0);
    precise real outflow = p.per_dx * (high_x - low_x) + p.per_dy * (high_y - low_y);
    return drain_part(h, outflow, p.dt);
}

// Mass and momentum along a face, as much of them as the cell that they leave can give.
vec2 given(vec4 flux, real low_drain, real high_drain) {
    precise vec2 part = flux.xy * (flux.x > 0 ? low_drain : high_drain);
    return part;
}

// Rate of change over the stage, times dt, of rise and discharge.
vec3 gain(int i, int j) {
    vec4 west = flux_x[at(i, j)], east = flux_x[at(i + 1, j)];
    vec4 south = flux_y[at(i, j)], north = flux_y[at(i, j + 1)];
    real own = drain(i, j);
    vec2 in_west = given(west, west.x > 0 ? drain(i - 1, j) : own, own);
    vec2 out_east = given(east, own, east.x > 0 ? own : drain(i + 1, j));
    vec2 in_south = given(south, south.x > 0 ? drain(i, j - 1) : own, own);
    vec2 out_north = given(north, own, north.x > 0 ? own : drain(i, j + 1));
    real push_x = p.per_dx * (west.w - east.z);
    real push_y = p.per_dy * (south.w - north.z);
    precise real rise = p.dt * (p.per_dx * (in_west.x - out_east.x) + p.per_dy * (in_south.x - out_north.x));
    return vec3(rise, p.dt * (push_x + p.per_dy * (in_south.y - out_north.y)),
                p.dt * (push_y + p.per_dx * (in_west.y - out_east.y)));
}

void first_stage(int k, vec3 gained) {
    precise real depth = start[k].y + now[k].x;
    precise real rise = gained.x < -depth ? -depth : gained.x;
    precise real next = start[k].y + (now[k].x + rise);
    change[k] = vec4(rise, gained.yz, next < 0 ? 0 : next);  // a NaN stays
}

void second_stage(int k, vec3 gained) {
    vec4 before = now[k];
    vec4 first = change[k];
    real empty = -start[k].y;
    precise real wanted = 0.5 * (first.x + gained.x) + before.w;
    precise real reached = before.x + wanted;
    precise real next = reached < empty ? empty : reached;  // a NaN stays
    precise real carry = wanted - (next - before.x);
    vec2 q = before.yz + 0.5 * (first.yz + gained.yz);
    if (p.friction > 0) q *= friction_part(start[k].y + next, length(q), p.friction, p.film);
    now[k] = vec4(next, q, carry);
}

// The discharge of a film follows its velocity. Returns the bits of the crossing rate.
uint settle(int k) {
    vec4 state = now[k];
    real h = start[k].y + state.x;
    vec2 velocity = state.yz * flow_per_discharge(h, p.film);
    if (h < p.film) now[k].yz = h * velocity;
    return rate_bits(crossing_rate(h, velocity.x, velocity.y, p.gravity, p.per_dx, p.per_dy));
}

uint update(int i, int j) {
    int k = at(i, j);
    if (p.stage == 1) first_stage(k, gain(i, j));
    if (p.stage == 2) second_stage(k, gain(i, j));
    return p.stage == 1 ? 0 : settle(k);
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    int j = int(gl_GlobalInvocationID.y);
    uint rate = i < p.nx && j < p.ny ? update(i, j) : 0;
    if (p.stage == 1) return;
    if (gl_LocalInvocationIndex == 0) fastest = 0;
    barrier();
    atomicMax(fastest, rate);
    barrier();
    if (gl_LocalInvocationIndex == 0) atomicMax(peak, fastest);
}
