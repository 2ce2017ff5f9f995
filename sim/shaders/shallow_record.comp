// Adds the state to the records of every cell.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "sim/shaders/shallow_fields.glsl"

#include "sim/kernels/shallow_records.glsl"

// CellRecord, and a fourth number of no account.
layout(std430, binding = 4) buffer Records { vec4 records[]; };

void main() {
    int i = int(gl_GlobalInvocationID.x);
    int j = int(gl_GlobalInvocationID.y);
    if (i >= p.nx || j >= p.ny) return;
    int k = at(i, j);
    vec2 first = start_at(k);
    vec4 state = now_at(k);
    real h = first.y + state.x;
    real speed = flow_per_discharge(h, p.film) * length(state.yz);
    bool wet = h > p.wet;
    CellRecord r = CellRecord(records[k].x, records[k].y, records[k].z);
    r = with_state(r, first.x + state.x, speed, wet, wet && state.x > p.wet, p.time);
    records[k] = vec4(r.highest, r.fastest, r.arrival, 0);
}
