// Nonlinear shallow water over ground of height z: depth h, surface e = z + h, velocity (u, v), discharge q = h u.
//   h_t + (h u)_x + (h v)_y = 0,   (h u)_t + (h u^2)_x + (h u v)_y = -g h e_x   and so along y.
// Finite volumes: MUSCL on (e, u, v), hydrostatic reconstruction (Audusse, Bouchut, Bristeau, Klein & Perthame 2004, SIAM
// J. Sci. Comput. 25, 2050), HLL (Harten, Lax & van Leer 1983) with the speeds of Toro 2001, "Shock-capturing methods for
// free-surface shallow flows", 10.5.1: two rarefactions, or dry fronts; Heun's SSP time step.
// Along one axis n is across a face and t along it; "low" and "high" are its two sides along the axis.

// Velocity of water of depth h and discharge q: q / h above the depth `film`, and smoothly 0 below it (Kurganov & Petrova
// 2007, Commun. Math. Sci. 5, 133, eq. 2.17 in another form).
KERNEL real flow_per_discharge(real h, real film) {
    real m = max(h, film);
    return real(2) * h / (h * h + m * m);
}

// Half of how steep a limited slope may be against its smaller one-sided difference: that is from 1 (minmod) in films
// thinner than the step of the ground between cells to 2 (Koren) in deep water. Steeper slopes in a film would dam it up
// by steps of their own.
KERNEL real slope_freedom(real h_low, real h, real h_high, real z_low, real z, real z_high) {
    real ground_step = max(abs(z - z_low), abs(z_high - z));
    real depth = min(h, min(h_low, h_high));
    return real(0.5) + real(0.5) * min(depth / (ground_step + real(1e-12)), real(1));
}

// How much a value lies lower at the low face than at the centre, and higher at the high face.
struct FaceSteps {
    real low;
    real high;
};

// The third-order upwind-biased steps (2 a + b) / 6 and (a + 2 b) / 6 from the differences a, b to the neighbours, limited
// (Koren 1993) to `freedom`, see slope_freedom(), times the smaller of a and b, and to 0 where they differ in sign.
// Mirrored to the last bit where the differences are.
KERNEL FaceSteps limited_steps(real a, real b, real freedom) {
    real most = freedom * max(min(a, b), real(0));
    real least = freedom * min(max(a, b), real(0));
    real sixth = real(1) / real(6);
    real sum = a + b;
    FaceSteps steps;
    steps.low = max(min(sixth * (sum + a), most), least);
    steps.high = max(min(sixth * (sum + b), most), least);
    return steps;
}

// Steps of the velocity across the faces, within half the speed of the cell's own waves: or else fast films on both sides of
// a deep cell give its faces more momentum than its water can stand against, and it swallows them without end.
KERNEL FaceSteps carried_steps(FaceSteps steps, real h, real g) {
    real most = real(0.5) * sqrt(g * h);
    FaceSteps carried;
    carried.low = clamp(steps.low, -most, most);
    carried.high = clamp(steps.high, -most, most);
    return carried;
}

// The step of the ground from the centre of a cell to its high face, and minus that to its low one: central, limited to
// twice the one-sided differences (van Leer 1977).
KERNEL real ground_step(real before, real after) {
    real rising = before + after > real(0) ? real(1) : real(-1);
    real a = max(rising * before, real(0));
    real b = max(rising * after, real(0));
    return rising * min(min(a, b), real(0.25) * (a + b));
}

// Depth at a face from the cell's own and what it gains up to there: the surface's rise less the ground's. Within 0 and
// twice the cell's own, so that a cell does not offer more than it holds.
KERNEL real face_depth(real h, real gain) {
    return clamp(h + gain, real(0), real(2) * h);
}

// The force of the surface's slope within a cell, times the cell's size: g (mean depth) (rise from face to face).
KERNEL real surface_force(real g, real h_low, real h_high, real e_low, real e_high) {
    return real(0.5) * g * (h_low + h_high) * (e_high - e_low);
}

// One side of a face.
struct FaceWater {
    real e;
    real h;
    real u;  // across the face
    real v;  // along it
};

// What passes a face per metre and second. Momentum across it is given as its excess over each side's own hydrostatic
// pressure at the face: that pressure and the ground's push are balanced within the cell, see surface_force(), so that
// every term is 0 where the surface is level.
struct FaceFlux {
    real mass;
    real push_low;   // on the cell on the low side
    real push_high;  // on the cell on the high side
    real along;      // momentum along the face
};

// Speeds of the slowest and the fastest wave from a face; 0 where all run to one side.
struct FaceSpeeds {
    real slow;
    real fast;
};

// No wave is taken for slower than the water and its own waves on its side, so the depth between them is never negative;
// nor than those on the other side, or a film would hold up deep fast water that it runs against.
KERNEL FaceSpeeds hll_speeds(FaceWater low, FaceWater high, real g) {
    real c_low = sqrt(g * low.h);
    real c_high = sqrt(g * high.h);
    real u_middle = real(0.5) * (low.u + high.u) + c_low - c_high;
    real c_middle = real(0.5) * (c_low + c_high) + real(0.25) * (low.u - high.u);
    real slow = min(min(low.u - c_low, high.u - c_high), u_middle - c_middle);
    real fast = max(max(high.u + c_high, low.u + c_low), u_middle + c_middle);
    slow = low.h > real(0) ? slow : high.u - real(2) * c_high;
    fast = high.h > real(0) ? fast : low.u + real(2) * c_low;
    FaceSpeeds speeds;
    speeds.slow = min(slow, real(0));
    speeds.fast = max(fast, real(0));
    return speeds;
}

// HLL between two depths over a ground that both share. `rise` is high.h - low.h, known better than from depths in which
// a small one is lost.
KERNEL FaceFlux hll_flux(FaceWater low, FaceWater high, real rise, real g) {
    FaceSpeeds speeds = hll_speeds(low, high, g);
    real slow = speeds.slow;
    real fast = speeds.fast;
    real per_width = real(1) / max(fast - slow, real(1e-18));
    real q_low = low.h * low.u;
    real q_high = high.h * high.u;
    real both = fast * slow;
    real pressure_step = real(0.5) * g * (low.h + high.h) * rise;
    real advected = fast * q_low * low.u - slow * q_high * high.u + both * (q_high - q_low);
    FaceFlux flux;
    flux.mass = per_width * (fast * q_low - slow * q_high + both * rise);
    flux.push_low = per_width * (advected - slow * pressure_step);
    flux.push_high = per_width * (advected - fast * pressure_step);
    flux.along = flux.mass * (flux.mass > real(0) ? low.v : high.v);
    return flux;
}

// The flux through a face between cells whose grounds may differ there: only what stands above the higher ground meets.
// In terms of the fall of the surface: between level surfaces both depths come out the same to the last bit, however high
// they are, and waves far smaller than the depth keep their force.
KERNEL FaceFlux shallow_flux(FaceWater low, FaceWater high, real g) {
    real fall = low.e - high.e;
    real low_h = clamp(high.h + fall, real(0), low.h);
    high.h = clamp(low.h - fall, real(0), high.h);
    low.h = low_h;
    return hll_flux(low, high, clamp(-fall, -low.h, high.h), g);
}

// The part of its outflow that a cell of depth h can give within a step, when `outflow` (m/s) leaves it over all faces.
KERNEL real drain_part(real h, real outflow, real dt) {
    real wanted = dt * outflow;
    return wanted > h ? h / wanted * real(0.999999) : real(1);
}

// Momentum across a face that stays behind with `mass`, the part of the flux that draining has cut.
KERNEL real held_momentum(real mass, real u_low, real u_high) {
    return mass * (mass > real(0) ? u_low : u_high);
}

// The depth that a cell must have had for what is left of its water to be slowed down.
KERNEL real slowing_depth(real left) {
    return real(4) * left;
}

// The part of its discharge that a cell keeps when its depth falls from h to `left`: what leaves takes its own along,
// so that the rest is not faster than it would be at its slowing_depth().
KERNEL real kept_flow(real h, real left) {
    real most = slowing_depth(left);
    return most < h ? most / h : real(1);
}

// What a step of dt leaves of the discharge under Manning's friction, q_t = -g n^2 |q| q / h^(7/3), solved exactly.
KERNEL real friction_part(real h, real discharge, real g_n2_dt, real film) {
    real m = max(h, film);
    // The power must not fall below what single precision holds.
    return real(1) / (real(1) + g_n2_dt * discharge / max(m * m * cbrt(m), real(1e-37)));
}

// Rate (1/s) at which the fastest waves cross a cell, both axes added: the Courant number of a step dt is dt times it.
KERNEL real crossing_rate(real h, real u, real v, real g, real per_dx, real per_dy) {
    real c = sqrt(g * h);
    return (abs(u) + c) * per_dx + (abs(v) + c) * per_dy;
}

// Slope of the surface, times the cell's size: from the rises to both neighbours (to_low = e_low - e) over those that are
// deeper than the film; 0 on dry ground.
KERNEL real shore_slope(real to_low, real to_high, real h_low, real h, real h_high, real film) {
    real low = h_low > film ? real(1) : real(0);
    real high = h_high > film ? real(1) : real(0);
    real neighbours = max(low + high, real(1));
    return h > film ? (high * to_high - low * to_low) / neighbours : real(0);
}
