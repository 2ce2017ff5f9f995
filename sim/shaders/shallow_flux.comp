// Flux through the low faces of every cell, of `now` (first stage) or of what the first stage led to (second). One cell
// more along each axis, for the faces of the far sides.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "sim/shaders/shallow_fields.glsl"

// Water of a cell; u along the axis, v along the face.
struct CellWater {
    real e, h, u, v, z;
};

CellWater water(int i, int j, bool along_y) {
    int k = at(i, j);
    vec4 state = now_at(k);
    vec4 added = change_at(k);
    if (p.stage == 2) state.xyz = vec3(state.x + added.x, added.yz);
    vec2 first = start_at(k);
    real depth = first.y + state.x;
    real h = depth < 0 ? 0 : depth;  // a NaN stays
    vec2 velocity = flow_per_discharge(h, p.film) * state.yz;
    if (along_y) velocity = velocity.yx;
    return CellWater(first.x + state.x, h, velocity.x, velocity.y, first.x - first.y);
}

// Both faces of a cell along one axis.
struct Faces {
    FaceWater low, high;
};

Faces faces(CellWater before, CellWater at, CellWater after) {
    real freedom = slope_freedom(before.h, at.h, after.h, before.z, at.z, after.z);
    real ground = ground_step(at.z - before.z, after.z - at.z);
    FaceSteps e = limited_steps(at.e - before.e, after.e - at.e, freedom);
    FaceSteps u = carried_steps(limited_steps(at.u - before.u, after.u - at.u, freedom), at.h, p.gravity);
    FaceSteps v = limited_steps(at.v - before.v, after.v - at.v, freedom);
    return Faces(FaceWater(at.e - e.low, face_depth(at.h, ground - e.low), at.u - u.low, at.v - v.low),
                 FaceWater(at.e + e.high, face_depth(at.h, e.high - ground), at.u + u.high, at.v + v.high));
}

// Mass and momentum along the low face of cell k of `cells`. At walls and rivers they are given and not what comes out
// between inside and frame.
vec2 passing(FaceFlux flux, int k, int cells, int low_side) {
    if (k > 0 && k < cells) return vec2(flux.mass, flux.along);
    int side = k == 0 ? low_side : low_side + 1;
    real inward = k == 0 ? 1 : -1;
    if (p.sides[side].kind == BEYOND_WALL) return vec2(0);
    if (p.sides[side].kind == BEYOND_DISCHARGE) return vec2(inward * p.sides[side].value, 0);
    return vec2(flux.mass, flux.along);
}

vec4 low_flux(int i, int j, bool along_y) {
    ivec2 one = along_y ? ivec2(0, 1) : ivec2(1, 0);
    CellWater w0 = water(i - 2 * one.x, j - 2 * one.y, along_y);
    CellWater w1 = water(i - one.x, j - one.y, along_y);
    CellWater w2 = water(i, j, along_y);
    CellWater w3 = water(i + one.x, j + one.y, along_y);
    Faces before = faces(w0, w1, w2);
    Faces here = faces(w1, w2, w3);
    FaceFlux f = shallow_flux(before.high, here.low, p.gravity);
    real force = surface_force(p.gravity, here.low.h, here.high.h, here.low.e, here.high.e);
    vec2 passes = along_y ? passing(f, j, p.ny, 2) : passing(f, i, p.nx, 0);
    return vec4(passes, f.push_low, f.push_high - force);
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    int j = int(gl_GlobalInvocationID.y);
    if (i <= p.nx && j < p.ny) flux_x[at(i, j)] = low_flux(i, j, false);
    if (i < p.nx && j <= p.ny) flux_y[at(i, j)] = low_flux(i, j, true);
}
