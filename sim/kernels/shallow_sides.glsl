// What lies beyond a side of the shallow-water model. u: velocity into the domain, c: sqrt(g h). In the water at a side,
// u - 2 c is what leaves along the characteristic from the inside, u + 2 c what comes in from the outside (Toro 2001,
// "Shock-capturing methods for free-surface shallow flows", 2.4 and 6.3.3). Everything is told by how far it differs from
// the water inside, so that small waves on deep water keep their digits in single precision.

#define BEYOND_WALL 0       // what is inside, mirrored
#define BEYOND_PERIODIC 1   // what is inside at the opposite side
#define BEYOND_WAVE 2       // what goes out leaves, a wave of the given elevation (m) comes in
#define BEYOND_DISCHARGE 3  // the given discharge comes in, m2/s
#define BEYOND_LEVEL 4      // held at the given elevation
#define BEYOND_FLOW 5       // the given elevation and velocity, whatever is inside
#define BEYOND_PISTON 6     // a wall that moves inward at the given speed, m/s

// What a side is asked for at a time.
struct SideDemand {
    int kind;    // BEYOND_
    real value;  // elevation, discharge or speed
    real u;      // of BEYOND_FLOW: into the domain
    real v;      // of BEYOND_FLOW: along the side
};

// The water just inside.
struct SideWater {
    real h;      // depth
    real e;      // surface above level 0
    real still;  // depth of water at level 0 over the same ground, negative where that is higher
    real u;      // into the domain
    real v;      // along the side
};

// The water beyond: how much deeper than inside, -h where it is dry, and its velocity.
struct BeyondWater {
    real deeper;
    real u;
    real v;
};

// sqrt(g (h + more)) - sqrt(g h).
KERNEL real celerity_gain(real h, real more, real g) {
    return g * more / max(sqrt(g * h) + sqrt(g * max(h + more, real(0))), real(1e-18));
}

// What level a adds to the depth of still water, where either may be below the ground.
KERNEL real depth_gain(real still, real a) { return still > real(0) ? max(a, -still) : max(still + a, real(0)); }

KERNEL bool is_blown_out(SideWater inside, real g) { return inside.u < -sqrt(g * inside.h); }

// For what leaves, and u + 2 c = 4 sqrt(g (still + a)) - 2 sqrt(g still) of a simple wave of elevation a that comes in from
// still water. With a = 0 the side is open. Faster than its waves, only the inside counts.
KERNEL BeyondWater beyond_wave(SideWater inside, real a, real g) {
    real still = max(inside.still, real(0));
    real c = sqrt(g * inside.h);
    real coming = celerity_gain(still, depth_gain(inside.still, a), g);
    real there = celerity_gain(still, inside.still > real(0) ? inside.e : inside.h, g);
    real gain = max(coming - real(0.25) * inside.u - real(0.5) * there, -c);
    bool blown_out = is_blown_out(inside, g);
    BeyondWater at;
    at.deeper = gain > -c ? gain * (real(2) * c + gain) / g : -inside.h;
    at.deeper = blown_out ? real(0) : at.deeper;
    at.u = blown_out ? inside.u : real(2) * coming + real(0.5) * inside.u - there;
    at.v = inside.v;
    return at;
}

// Held at elevation a.
KERNEL BeyondWater beyond_level(SideWater inside, real a, real g) {
    real deeper = max(a - inside.e, -inside.h);
    bool blown_out = is_blown_out(inside, g);
    BeyondWater at;
    at.deeper = blown_out ? real(0) : deeper;
    at.u = blown_out ? inside.u : inside.u + real(2) * celerity_gain(inside.h, deeper, g);
    at.v = at.u > real(0) ? real(0) : inside.v;
    return at;
}

// Through which q (m2/s) >= 0 comes in: c^2 (u - 2 c + 2 c) = g q with what leaves, by Newton's method from above the
// largest root.
KERNEL BeyondWater beyond_discharge(SideWater inside, real q, real g) {
    real c_inside = sqrt(g * inside.h);
    real leaving = inside.u - real(2) * c_inside;
    real c = max(-leaving, real(0)) + cbrt(g * q) + real(1e-9);
    for (int n = 0; n < 40; ++n) {
        real f = (real(2) * c + leaving) * c * c - g * q;
        real slope = (real(6) * c + real(2) * leaving) * c;
        c -= f / max(slope, real(1e-30));
    }
    BeyondWater at;
    at.deeper = q > real(0) ? (c - c_inside) * (c + c_inside) / g : real(0);
    at.u = q > real(0) ? g * q / (c * c) : -inside.u;
    at.v = real(0);
    return at;
}

// For every kind of side at which water is not simply copied.
KERNEL BeyondWater beyond_side(SideDemand demand, SideWater inside, real g) {
    if (demand.kind == BEYOND_WAVE) return beyond_wave(inside, demand.value, g);
    if (demand.kind == BEYOND_DISCHARGE) return beyond_discharge(inside, demand.value, g);
    if (demand.kind == BEYOND_LEVEL) return beyond_level(inside, demand.value, g);
    BeyondWater at;
    bool piston = demand.kind == BEYOND_PISTON;
    at.deeper = piston ? real(0) : max(demand.value - inside.e, -inside.h);
    at.u = piston ? real(2) * demand.value - inside.u : demand.u;
    at.v = piston ? inside.v : demand.v;
    return at;
}

// How many cells inward of the side lies what stands for frame cell -1 or -2; `across` cells lie between the side and
// its opposite.
KERNEL int frame_source(int kind, int frame, int across) {
    if (kind == BEYOND_PERIODIC) return across + frame < 0 ? 0 : across + frame;
    bool mirrors = kind == BEYOND_WALL || kind == BEYOND_PISTON;
    int mirrored = -1 - frame < across ? -1 - frame : across - 1;
    return mirrors ? mirrored : 0;
}
