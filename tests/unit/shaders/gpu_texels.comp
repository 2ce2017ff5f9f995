// to[i] = (1 + 10 + 100) from[i], by texels of one, two and four numbers.
#version 460

layout(local_size_x_id = 0, local_size_y_id = 1, local_size_z_id = 2) in;

layout(push_constant) uniform Push { int count; };
layout(std430, binding = 0) writeonly buffer To { float to[]; };
layout(binding = 1) uniform samplerBuffer ones;
layout(binding = 2) uniform samplerBuffer pairs;
layout(binding = 3) uniform samplerBuffer fours;

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i < count)
        to[i] = texelFetch(ones, i).x + 10 * texelFetch(pairs, i / 2)[i % 2] + 100 * texelFetch(fours, i / 4)[i % 4];
}
