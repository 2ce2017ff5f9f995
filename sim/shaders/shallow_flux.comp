// Flux through the low faces of every cell, of `now` (first stage) or of now + change (second). One cell more along each
// axis, for the faces of the far sides.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "sim/shaders/shallow_fields.glsl"

// Water of a cell; u along the axis, v along the face.
struct CellWater {
    real e, h, u, v, z;
};

CellWater water(int i, int j, bool along_y) {
    int k = at(i, j);
    vec4 state = now[k];
    if (p.stage == 2) state.xyz += change[k].xyz;
    vec2 first = start[k];
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
    FaceSteps u = limited_steps(at.u - before.u, after.u - at.u, freedom);
    FaceSteps v = limited_steps(at.v - before.v, after.v - at.v, freedom);
    real e_low = at.e - e.low;
    real e_high = at.e + e.high;
    return Faces(FaceWater(e_low, face_depth(e_low, at.z - ground, at.h), at.u - u.low, at.v - v.low),
                 FaceWater(e_high, face_depth(e_high, at.z + ground, at.h), at.u + u.high, at.v + v.high));
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
    return vec4(f.mass, f.along, f.push_low, f.push_high - force);
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    int j = int(gl_GlobalInvocationID.y);
    if (i <= p.nx && j < p.ny) flux_x[at(i, j)] = low_flux(i, j, false);
    if (i < p.nx && j <= p.ny) flux_y[at(i, j)] = low_flux(i, j, true);
}
