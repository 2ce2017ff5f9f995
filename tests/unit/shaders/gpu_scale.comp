// to[i] = factor * from[i]
#version 460

layout(local_size_x_id = 0, local_size_y_id = 1, local_size_z_id = 2) in;

layout(push_constant) uniform Push {
    float factor;
    int count;
};
layout(std430, binding = 0) readonly buffer From { float from[]; };
layout(std430, binding = 1) writeonly buffer To { float to[]; };

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i < count) to[i] = factor * from[i];
}
