// Exact solutions of the shallow-water equations over ground z,
//   h_t + div(h u) = 0,   (h u)_t + div(h u u) + grad(g h^2 / 2) = -g h grad z.

struct ExactFlow {
    real depth;
    real2 velocity;
};

KERNEL ExactFlow exact_dry() {
    ExactFlow dry = {real(0), real2(real(0), real(0))};
    return dry;
}

// Bowls: z = h0 (r^2/a^2 - 1) about the still level. Thacker (1981), "Some exact solutions to the nonlinear
// shallow-water wave equations". r: position from the middle; turn: w t.

// The surface stays plane and goes round; the water covers a circle of radius a about eta (cos wt, sin wt).
KERNEL real thacker_planar_omega(real h0, real a, real g) {
    return sqrt(real(2) * g * h0) / a;
}

KERNEL ExactFlow thacker_planar(real2 r, real turn, real h0, real a, real eta, real omega) {
    real2 centre = eta * real2(cos(turn), sin(turn));
    real h = h0 * (real(1) - dot(r - centre, r - centre) / (a * a));
    if (h <= real(0)) return exact_dry();
    ExactFlow flow = {h, omega * real2(-centre.y, centre.x)};
    return flow;
}

// The surface is a paraboloid that swings; the shore is a circle of radius r0 at t = 0 (SWASHES, 4.2.2, has squares for
// fourth powers in A: its shore is at sqrt(a r0)).
KERNEL real thacker_radial_omega(real h0, real a, real g) {
    return sqrt(real(8) * g * h0) / a;
}

KERNEL ExactFlow thacker_radial(real2 r, real turn, real h0, real a, real r0, real omega) {
    real a4 = a * a * a * a;
    real r4 = r0 * r0 * r0 * r0;
    real A = (a4 - r4) / (a4 + r4);
    real swing = real(1) - A * cos(turn);
    real s = sqrt(real(1) - A * A) / swing;
    real h = h0 * s * (real(1) - s * dot(r, r) / (a * a));
    if (h <= real(0)) return exact_dry();
    ExactFlow flow = {h, (real(0.5) * omega * A * sin(turn) / swing) * r};
    return flow;
}

// A vortex in balance, carried along. r: position from its middle; carried: velocity of the water far away.
KERNEL ExactFlow shallow_vortex(real2 r, real2 carried, real h0, real beta, real g) {
    real f = beta / real(6.283185307179586) * exp(real(0.5) * (real(1) - dot(r, r)));
    ExactFlow flow = {h0 - f * f / (real(2) * g), carried + f * real2(-r.y, r.x)};
    return flow;
}

// Riemann's problem on flat ground, in one direction. Stoker (1957), Water Waves, 10.8; Toro (2001), Shock-
// capturing methods for free-surface shallow flows, ch. 5 and 6. Equation numbers are Toro's.

// How much the velocity changes across the wave from depth hk > 0 to h: rarefaction or shock (5.8), and its slope.
struct RiemannCurve {
    real value;
    real slope;
};

KERNEL RiemannCurve riemann_curve(real h, real hk, real g) {
    RiemannCurve curve;
    if (h <= hk) {
        curve.value = real(2) * (sqrt(g * h) - sqrt(g * hk));
        curve.slope = sqrt(g / h);
    } else {
        real q = sqrt(real(0.5) * g * (h + hk) / (h * hk));
        curve.value = (h - hk) * q;
        curve.slope = q - real(0.25) * g * (h - hk) / (h * h * q);
    }
    return curve;
}

// Between the two waves; depth 0 where the bed falls or stays dry.
struct RiemannStar {
    real depth;
    real velocity;
};

// Both depths > 0 and no dry bed between. The jump of velocity rises with h and bends down: Newton's method from a
// depth below the root climbs to it without fail.
KERNEL real riemann_star_depth(real hl, real ul, real hr, real ur, real g) {
    real low = min(hl, hr);
    real high = max(hl, hr);
    real jump = ur - ul;
    if (riemann_curve(low, hl, g).value + riemann_curve(low, hr, g).value + jump >= real(0)) {
        real c = real(0.5) * (sqrt(g * hl) + sqrt(g * hr)) - real(0.25) * jump;
        return c * c / g;
    }
    real h = riemann_curve(high, hl, g).value + riemann_curve(high, hr, g).value + jump <= real(0) ? high : low;
    for (int n = 0; n < 200; ++n) {
        RiemannCurve left = riemann_curve(h, hl, g);
        RiemannCurve right = riemann_curve(h, hr, g);
        real next = h - (left.value + right.value + jump) / (left.slope + right.slope);
        if (next <= h) break;
        h = next;
    }
    return h;
}

KERNEL RiemannStar riemann_star(real hl, real ul, real hr, real ur, real g) {
    RiemannStar star = {real(0), real(0)};
    if (hl <= real(0) || hr <= real(0)) return star;
    // Condition (6.4): the rarefactions part.
    if (ur - ul >= real(2) * (sqrt(g * hl) + sqrt(g * hr))) return star;
    star.depth = riemann_star_depth(hl, ul, hr, ur, g);
    star.velocity = real(0.5) * (ul + ur + riemann_curve(star.depth, hr, g).value -
                                 riemann_curve(star.depth, hl, g).value);
    return star;
}

// Speed of the shock that runs with +x from star.depth into depth h, velocity u (5.44).
KERNEL real riemann_shock_speed(real star_depth, real h, real u, real g) {
    return u + sqrt(real(0.5) * g * star_depth * (star_depth + h) / h);
}

// Left of the contact at x/t = xi: left state, left wave, star. The right half is its mirror image.
KERNEL RiemannStar riemann_left_half(real xi, real h, real u, RiemannStar star, real g) {
    RiemannStar dry = {real(0), real(0)};
    RiemannStar still = {h, u};
    if (h <= real(0)) return dry;
    if (star.depth > h) return xi <= -riemann_shock_speed(star.depth, h, -u, g) ? still : star;
    real c = sqrt(g * h);
    if (xi <= u - c) return still;
    if (star.depth <= real(0) && xi >= u + real(2) * c) return dry;
    if (star.depth > real(0) && xi >= star.velocity - sqrt(g * star.depth)) return star;
    real fan_c = (u + real(2) * c - xi) / real(3);
    RiemannStar fan = {fan_c * fan_c / g, (u + real(2) * c + real(2) * xi) / real(3)};
    return fan;
}

// The solution at x/t = xi.
KERNEL RiemannStar riemann_at(real xi, real hl, real ul, real hr, real ur, real g) {
    RiemannStar star = riemann_star(hl, ul, hr, ur, g);
    bool dry_between = star.depth <= real(0);
    // Where the bed between is dry, each half ends by itself: the left one wherever it is wet.
    RiemannStar left = riemann_left_half(xi, hl, ul, star, g);
    if (dry_between ? left.depth > real(0) : xi <= star.velocity) return left;
    RiemannStar mirror = {star.depth, -star.velocity};
    RiemannStar right = riemann_left_half(-xi, hr, -ur, mirror, g);
    right.velocity = -right.velocity;
    return right;
}

// Steady flow over uneven ground: h + q^2/(2 g h^2) + z is the head. Critical depth hc = (q^2/g)^(1/3).

// h/hc, where the head over the ground exceeds the least possible, 3/2 hc, by e hc >= 0. In x = h/hc,
//   (x - 1)^2 (x + 1/2) = e x^2,  so that  x - 1 = +- x sqrt(e/(x + 1/2)),
// well-conditioned down to e = 0. Newton's method from the outer side of either root is monotone.
KERNEL real bernoulli_depth_ratio(real e, bool subcritical) {
    real side = subcritical ? real(1) : real(-1);
    real x = subcritical ? real(1.5) + e : real(0);
    for (int n = 0; n < 100; ++n) {
        real root = sqrt(e / (x + real(0.5)));
        real miss = x - real(1) - side * x * root;
        real slope = real(1) - side * root * real(0.5) * (x + real(1)) / (x + real(0.5));
        real next = x - miss / slope;
        if (side * (x - next) <= real(0)) break;
        x = next;
    }
    return x;
}

// Depth behind a jump over depth ahead of it, of Froude number F normal to it: Belanger's equation.
KERNEL real jump_depth_ratio(real froude2) {
    return real(0.5) * (sqrt(real(1) + real(8) * froude2) - real(1));
}

// An oblique hydraulic jump, attached and weak: Ippen (1951), "Mechanics of supercritical flow", eq. 5 to 8. Along
// the jump velocity is kept, so tan(angle) / tan(angle - deflection) is the ratio of depths.

struct ObliqueTurn {
    real deflection;
    real slope;  // d deflection / d angle
};

KERNEL ObliqueTurn oblique_turn(real angle, real froude) {
    real s = sin(angle);
    real c = cos(angle);
    real normal = froude * s;
    real ratio = jump_depth_ratio(normal * normal);
    real ratio_slope = real(4) * normal * froude * c / (real(2) * ratio + real(1));
    real w = s / (c * ratio);
    real w_slope = real(1) / (c * c * ratio) - w * ratio_slope / ratio;
    ObliqueTurn turn = {angle - atan(w), real(1) - w_slope / (real(1) + w * w)};
    return turn;
}

// Newton's method from the Mach angle, which does not turn the flow; from there the deflection rises and bends down.
// Where no attached jump exists the result does not turn the flow by `deflection`.
KERNEL real oblique_jump_angle(real froude, real deflection) {
    real angle = asin(real(1) / froude);
    for (int n = 0; n < 100; ++n) {
        ObliqueTurn turn = oblique_turn(angle, froude);
        if (turn.slope <= real(0)) break;
        real next = angle + (deflection - turn.deflection) / turn.slope;
        if (next <= angle || next >= real(1.5707963267948966)) break;
        angle = next;
    }
    return angle;
}

// A solitary wave of height a on depth d, at distance s from its crest: Boussinesq's profile. It keeps its form, so
// that the discharge is c times the elevation.

KERNEL real solitary_speed(real a, real d, real g) {
    return sqrt(g * (d + a));
}

KERNEL real solitary_elevation(real s, real a, real d) {
    // sech(x) = 2 / (e^x + e^-x) without overflow.
    real decay = exp(-abs(s) * sqrt(real(0.75) * a / (d * d * d)));
    real sech = real(2) * decay / (real(1) + decay * decay);
    return a * sech * sech;
}
