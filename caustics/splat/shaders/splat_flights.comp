// Lands light that the host has followed through objects.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "sim/kernels/real.glsl"

#include "caustics/kernels/optics.glsl"
#include "caustics/kernels/splat.glsl"
#include "caustics/kernels/surface_lookup.glsl"
#include "caustics/splat/shaders/splat_parameters.glsl"

layout(local_size_x_id = 0, local_size_y_id = 1, local_size_z_id = 2) in;

layout(std430, binding = 0) readonly buffer Parameters { SplatParameters p; };
layout(std430, binding = 1) readonly buffer Flights { SplatFlight flights[]; };
layout(std430, binding = 2) readonly buffer Heights { float heights[]; };
layout(std430, binding = 3) writeonly buffer Landings { SplatLanding landings[]; };
layout(std430, binding = 4) writeonly buffer Accounts { SplatAccount accounts[]; };

#include "caustics/splat/shaders/splat_landing.glsl"

void main() {
    int chunk = int(gl_WorkGroupID.y);
    int me = int(gl_LocalInvocationID.x);
    int workers = int(gl_WorkGroupSize.x);
    int end = min(p.count, (chunk + 1) * splat_chunk);
    SplatAccount account = SplatAccount(0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
    for (int k = chunk * splat_chunk + me; k < end; k += workers) {
        SplatFlight f = flights[k];
        landings[k] = land_from(vec3(f.x, f.y, f.z), vec3(f.way_x, f.way_y, f.way_z), f.power, f.extinction, f.own != 0,
                                ivec2(f.pixel_x, f.pixel_y), vec2(f.part_x, f.part_y), account);
    }
    accounts[chunk * workers + me] = account;
}
