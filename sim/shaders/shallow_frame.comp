// What lies beyond the sides: x along a side, y = 0 and 1 the frame cells -1 and -2, z the side: west, east, south, north.
// Fills `now`, and also finds the fastest waves that may flow in; or, after the first stage, `change`, such that it
// leads to what lies beyond.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "sim/shaders/shallow_fields.glsl"

SHALLOW_PEAK

struct Side {
    SideDemand demand;
    bool along_y;  // the side runs along y: west or east
    bool high;     // east or north
};

Side side_of(uint n) {
    SideDemand demand = SideDemand(p.sides[n].kind, p.sides[n].value, p.sides[n].u, p.sides[n].v);
    return Side(demand, n < 2, (n & 1) == 1);
}

int across(Side side) { return side.along_y ? p.nx : p.ny; }

// The n-th cell along the side, `depth` cells inward, or outward where negative.
int place(Side side, int n, int depth) {
    int k = side.high ? across(side) - 1 - depth : depth;
    return side.along_y ? at(k, n) : at(n, k);
}

// What stands in the frame for the water of cell `from`: its rise, and discharge along x and y.
vec3 beyond(Side side, int from, vec3 state) {
    real inward = side.high ? -1 : 1;
    vec2 first = start_at(from);
    real e = first.x + state.x;
    real h = max(first.y + state.x, 0);
    vec2 velocity = flow_per_discharge(h, p.film) * (side.along_y ? state.yz : state.zy);
    // A wave is above level 0, any other demand above the datum.
    if (side.demand.kind == BEYOND_WAVE) e += p.datum;
    SideWater inside = SideWater(h, e, first.y - first.x - p.datum, inward * velocity.x, velocity.y);
    BeyondWater there = beyond_side(side.demand, inside, p.gravity);
    real rise = there.deeper > -h ? state.x + there.deeper : -first.y;  // dry to the last digit
    real h_beyond = max(h + there.deeper, 0);
    vec2 u = vec2(inward * there.u, there.v);
    if (!side.along_y) u = u.yx;
    if (p.stage != 1) atomicMax(peak, rate_bits(crossing_rate(h_beyond, u.x, u.y, p.gravity, p.per_dx, p.per_dy)));
    return vec3(rise, h_beyond * u);
}

vec3 mirrored(Side side, vec3 state) {
    return side.along_y ? vec3(state.x, -state.y, state.z) : vec3(state.xy, -state.z);
}

void main() {
    Side side = side_of(gl_GlobalInvocationID.z);
    int n = int(gl_GlobalInvocationID.x);
    int frame = -1 - int(gl_GlobalInvocationID.y);
    if (n >= (side.along_y ? p.ny : p.nx) || frame < -2) return;
    int from = place(side, n, frame_source(side.demand.kind, frame, across(side)));
    int to = place(side, n, frame);
    bool first = p.stage == 1;
    vec3 inside = first ? change[from].xyz : now[from].xyz;
    bool wall = side.demand.kind == BEYOND_WALL;
    vec3 copied = wall ? mirrored(side, inside) : inside;
    if (!wall && side.demand.kind != BEYOND_PERIODIC) {
        if (first) inside.x += now[from].x;
        copied = beyond(side, from, inside);
        if (first) copied.x -= now[to].x;
    }
    if (first)
        change[to] = vec4(copied, 0);
    else
        now[to] = vec4(copied, 0);
}
