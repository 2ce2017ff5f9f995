// What the passes of the shallow-water model work on: fields of nx + 4 by ny + 4 cells, two beyond every side, x fastest.
#extension GL_GOOGLE_include_directive : require

#include "sim/kernels/real.glsl"

#include "sim/kernels/shallow_sides.glsl"
#include "sim/kernels/shallow_water.glsl"
#include "sim/shaders/shallow_parameters.glsl"

layout(local_size_x_id = 0, local_size_y_id = 1, local_size_z_id = 2) in;

layout(push_constant) uniform Push { ShallowParameters p; };
// Rise, discharge along x and y, and the carry of the rise: what rounding has kept from it so far.
layout(std430, binding = 0) buffer Now { vec4 now[]; };
// What the first stage adds to the rise, the discharge along x and y that it leads to, and the depth.
layout(std430, binding = 1) buffer Change { vec4 change[]; };
// Through the low face of a cell along x and along y: mass, momentum along the face, push on the cell on the low side,
// and push on this cell less the force of the surface within it.
layout(std430, binding = 2) buffer FluxX { vec4 flux_x[]; };
layout(std430, binding = 3) buffer FluxY { vec4 flux_y[]; };
// Binding 4 is a pass's own: SHALLOW_PEAK or its records.

// The same as texels, for cells that the pass does not write, or not before it reads them: a device that is a CPU takes
// numbers of buffers one by one, and texels of several invocations at once. Surface and depth at the start are only here.
layout(binding = 5) uniform samplerBuffer start_texels;
layout(binding = 6) uniform samplerBuffer now_texels;
layout(binding = 7) uniform samplerBuffer change_texels;
layout(binding = 8) uniform samplerBuffer flux_x_texels;
layout(binding = 9) uniform samplerBuffer flux_y_texels;

vec2 start_at(int k) { return texelFetch(start_texels, k).xy; }
vec4 now_at(int k) { return texelFetch(now_texels, k); }
vec4 change_at(int k) { return texelFetch(change_texels, k); }
vec4 flux_x_at(int k) { return texelFetch(flux_x_texels, k); }
vec4 flux_y_at(int k) { return texelFetch(flux_y_texels, k); }

// Bits of the largest crossing rate: of numbers that are not negative they have the same order, and a NaN is on top.
#define SHALLOW_PEAK layout(std430, binding = 4) buffer Peak { uint peak; };

bool is_periodic_x() { return p.sides[0].kind == BEYOND_PERIODIC; }
bool is_periodic_y() { return p.sides[2].kind == BEYOND_PERIODIC; }

int at(int i, int j) { return (j + 2) * (p.nx + 4) + i + 2; }

uint rate_bits(real rate) { return floatBitsToUint(rate) & 0x7fffffffu; }
