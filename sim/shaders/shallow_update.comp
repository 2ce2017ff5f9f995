// What the fluxes make of every cell: `change` after the first stage, `now` after the second; a look leaves the state as
// it is. After all but the first stage the discharge of films is settled and the fastest waves are found. Numbers are
// precise where a cell and its neighbour must come to the same one, or where a carry would be simplified away.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "sim/shaders/shallow_fields.glsl"

SHALLOW_PEAK

shared uint fastest;

// What a cell gives through its faces: the part of its outflow that it can, and the velocity of the rest. Beyond the
// sides all of it.
struct Donor {
    real part;
    vec2 velocity;
};

real outflow(int i, int j) {
    real low_x = min(flux_x_at(at(i, j)).x, 0);
    real high_x = max(flux_x_at(at(i + 1, j)).x, 0);
    real low_y = min(flux_y_at(at(i, j)).x, 0);
    real high_y = max(flux_y_at(at(i, j + 1)).x, 0);
    precise real all = p.per_dx * (high_x - low_x) + p.per_dy * (high_y - low_y);
    return all;
}

// Discharge and depth of a cell that the stage starts from.
vec3 from(int k) {
    if (p.stage == 2) return change_at(k).yzw;
    vec4 state = now_at(k);
    precise real depth = start_at(k).y + state.x;
    return vec3(state.yz, depth < 0 ? 0 : depth);  // a NaN stays
}

Donor donor(int i, int j) {
    if (is_periodic_x()) i = i < 0 ? p.nx - 1 : i == p.nx ? 0 : i;
    if (is_periodic_y()) j = j < 0 ? p.ny - 1 : j == p.ny ? 0 : j;
    if (i < 0 || i >= p.nx || j < 0 || j >= p.ny) return Donor(1, vec2(0));
    vec3 water = from(at(i, j));
    real part = drain_part(water.z, outflow(i, j), p.dt);
    return Donor(part, part < 1 ? flow_per_discharge(water.z, p.film) * water.xy : vec2(0));
}

// Of the flux through a face what its donor can give.
struct Given {
    real mass, along;
    real held;  // momentum across the face that stays behind
};

Given given(vec4 flux, Donor donor, bool along_y) {
    precise vec2 part = flux.xy * donor.part;
    real velocity = along_y ? donor.velocity.y : donor.velocity.x;
    return Given(part.x, part.y, held_momentum(flux.x - part.x, velocity, velocity));
}

// The rise that the stage adds, and the discharge that it leads to.
vec3 advanced(int i, int j) {
    vec4 flux_west = flux_x_at(at(i, j)), flux_east = flux_x_at(at(i + 1, j));
    vec4 flux_south = flux_y_at(at(i, j)), flux_north = flux_y_at(at(i, j + 1));
    Donor own = donor(i, j);
    Given west = given(flux_west, flux_west.x > 0 ? donor(i - 1, j) : own, false);
    Given east = given(flux_east, flux_east.x > 0 ? own : donor(i + 1, j), false);
    Given south = given(flux_south, flux_south.x > 0 ? donor(i, j - 1) : own, true);
    Given north = given(flux_north, flux_north.x > 0 ? own : donor(i, j + 1), true);
    vec2 push = vec2(p.per_dx * (flux_west.w - flux_east.z + east.held - west.held),
                     p.per_dy * (flux_south.w - flux_north.z + north.held - south.held));
    vec2 carried = vec2(p.per_dy * (south.along - north.along), p.per_dx * (west.along - east.along));
    precise real rise = p.dt * (p.per_dx * (west.mass - east.mass) + p.per_dy * (south.mass - north.mass));
    vec3 water = from(at(i, j));
    return vec3(rise, kept_flow(water.z, water.z + rise) * (water.xy + p.dt * (push + carried)));
}

void first_stage(int k, vec3 reached) {
    real depth_at_start = start_at(k).y, before = now_at(k).x;
    precise real depth = depth_at_start + before;
    precise real rise = reached.x < -depth ? -depth : reached.x;
    precise real next = depth_at_start + (before + rise);
    change[k] = vec4(rise, reached.yz, next < 0 ? 0 : next);  // a NaN stays
}

// What half of the step's friction leaves of discharge q.
real rubbed(real h, vec2 q) {
    return p.friction > 0 ? friction_part(h, length(q), p.friction, p.film) : 1;
}

// What the step makes of `before`.
vec4 second_stage(int k, vec4 before, vec3 reached) {
    real empty = -start_at(k).y;
    precise real wanted = 0.5 * (change_at(k).x + reached.x) + before.w;
    precise real level = before.x + wanted;
    precise real next = level < empty ? empty : level;  // a NaN stays
    precise real carry = wanted - (next - before.x);
    vec2 q = 0.5 * (before.yz + reached.yz);
    return vec4(next, q * rubbed(next - empty, q), carry);
}

// The discharge of a film follows its velocity. Returns the bits of the crossing rate.
uint settle(int k, vec4 state) {
    real h = start_at(k).y + state.x;
    vec2 velocity = state.yz * flow_per_discharge(h, p.film);
    if (h < p.film) state.yz = h * velocity;
    if (h < p.film || p.stage == 2) now[k] = state;
    return rate_bits(crossing_rate(h, velocity.x, velocity.y, p.gravity, p.per_dx, p.per_dy));
}

uint update(int i, int j) {
    int k = at(i, j);
    vec4 state = now_at(k);
    if (p.stage == 3) now[k].yz = state.yz * rubbed(start_at(k).y + state.x, state.yz);
    if (p.stage == 1) first_stage(k, advanced(i, j));
    if (p.stage == 2) state = second_stage(k, state, advanced(i, j));
    return p.stage == 1 || p.stage == 3 ? 0 : settle(k, state);
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    int j = int(gl_GlobalInvocationID.y);
    uint rate = i < p.nx && j < p.ny ? update(i, j) : 0;
    if (p.stage == 1 || p.stage == 3) return;
    if (gl_LocalInvocationIndex == 0) fastest = 0;
    barrier();
    atomicMax(fastest, rate);
    barrier();
    if (gl_LocalInvocationIndex == 0) atomicMax(peak, fastest);
}
