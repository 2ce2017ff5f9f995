// What lies beyond a side of the shallow-water model. u: velocity into the domain, c: sqrt(g h). In the water at a side,
// u - 2 c is what leaves along the characteristic from the inside, u + 2 c what comes in from the outside (Toro 2001,
// "Shock-capturing methods for free-surface shallow flows", 2.4 and 6.3.3).

struct SideWater {
    real h;  // depth
    real u;  // velocity into the domain
};

// The water at the side for what leaves and what comes in; faster than its waves, only the inside counts.
KERNEL SideWater side_water(SideWater inside, real coming_in, real g) {
    real c_inside = sqrt(g * inside.h);
    real leaving = inside.u - real(2) * c_inside;
    real c = max(real(0.25) * (coming_in - leaving), real(0));
    bool blown_out = inside.u < -c_inside;
    SideWater at;
    at.h = blown_out ? inside.h : c * c / g;
    at.u = blown_out ? inside.u : real(0.5) * (coming_in + leaving);
    return at;
}

// What a simple wave of elevation a brings in from water of depth `still` beyond the side: u + 2 c with u = 2 (c - c0).
// With a = 0 the side is open.
KERNEL real incident_characteristic(real still, real a, real g) {
    real c0 = sqrt(g * max(still, real(0)));
    return real(4) * sqrt(g * max(still + a, real(0))) - real(2) * c0;
}

// The water at a side that is held at depth h.
KERNEL SideWater held_water(SideWater inside, real h, real g) {
    real c_inside = sqrt(g * inside.h);
    bool blown_out = inside.u < -c_inside;
    SideWater at;
    at.h = blown_out ? inside.h : max(h, real(0));
    at.u = blown_out ? inside.u : inside.u - real(2) * c_inside + real(2) * sqrt(g * at.h);
    return at;
}

// The water at a side through which q (m2/s) >= 0 comes in: c^2 (u - 2 c + 2 c) = g q with what leaves, by Newton's
// method from above the largest root.
KERNEL SideWater river_water(SideWater inside, real q, real g) {
    real leaving = inside.u - real(2) * sqrt(g * inside.h);
    real c = max(-leaving, real(0)) + cbrt(g * q) + real(1e-9);
    for (int n = 0; n < 40; ++n) {
        real f = (real(2) * c + leaving) * c * c - g * q;
        real slope = (real(6) * c + real(2) * leaving) * c;
        c -= f / max(slope, real(1e-30));
    }
    SideWater at;
    at.h = q > real(0) ? c * c / g : inside.h;
    at.u = q > real(0) ? g * q / (c * c) : -inside.u;
    return at;
}
