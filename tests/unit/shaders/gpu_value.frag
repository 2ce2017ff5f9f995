#version 460

layout(constant_id = 0) const float factor = 1;
layout(location = 0) flat in float value;
layout(location = 0) out float added;

void main() {
    added = factor * value;
}
