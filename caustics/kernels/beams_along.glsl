// Rays that run along the beams of a cell, in the words of beams.glsl. They are abreast of nothing, or of everything: not
// the section abreast counts, but the horizontal sections in the depths that they pass.

// The most by which an edge's travel differs from the mean, squared.
KERNEL real largest_off2(real2 off0, real2 off1, real2 off2, real2 off3) {
    return max(max(dot(off0, off0), dot(off1, off1)), max(dot(off2, off2), dot(off3, off3)));
}

// Whether a ray does: within 0.6 degrees of the mean (`length` = |r|), or where the ray passes no faster than sixteen times
// as fast as the edges themselves move.
KERNEL bool runs_along(real2 v, real length, real down, real off2) {
    return v.x * v.x + v.y * v.y < max(real(1e-4) * length * length, real(256) * off2 * down * down);
}

// How fast an edge passes the ray, and U(t).
KERNEL real2 edge_speed(real2 off, real2 v, real down) {
    return real2(v.x + down * off.x, v.y + down * off.y);
}

KERNEL real2 beside_ray(real2 at, real2 off, real2 v, real down, real t) {
    real2 speed = edge_speed(off, v, down);
    return real2(at.x + t * speed.x, at.y + t * speed.y);
}

// Twice the signed areas that the origin spans with the sides of a section: positive, or negative, of all three sides of
// a beam where the ray is in it, and then together twice the section's.
struct CellSides {
    real s01;
    real s12;
    real s20;
    real s23;
    real s30;
};

KERNEL CellSides cell_sides(real2 u0, real2 u1, real2 u2, real2 u3) {
    CellSides s;
    s.s01 = u0.x * u1.y - u0.y * u1.x;
    s.s12 = u1.x * u2.y - u1.y * u2.x;
    s.s20 = u2.x * u0.y - u2.y * u0.x;
    s.s23 = u2.x * u3.y - u2.y * u3.x;
    s.s30 = u3.x * u0.y - u3.y * u0.x;
    return s;
}

// What a part of a ray leaves of [s.near, s.far] on the inside of a side: `begin` and `end` are the side's numbers at
// the part's ends, 0 and 1, taken as linear between. Neighbours share them, so that each place is in one of both.
KERNEL WaterSpan within_side(WaterSpan s, real begin, real end) {
    real rate = end - begin;
    real cross = -begin / (abs(rate) < real(1e-30) ? real(1e-30) : rate);
    WaterSpan w;
    w.near = rate < real(0) ? s.near : max(s.near, cross);
    w.far = rate < real(0) ? min(s.far, cross) : s.far;
    return w;
}

// A side's number within a part: side = (at its begin, at its end, what the edges' speeds span times its length squared).
KERNEL real side_at(real3 side, real part) {
    return side.x + part * (side.y - side.x - (real(1) - part) * side.z);
}

// The length of a part within a beam over twice its section's area in the middle, for sections that turn one way. A
// section that folds while the ray passes beside it may seem to hold the ray: the exact numbers of the middle say no.
KERNEL real density_along(WaterSpan s, real3 a, real3 b, real3 c) {
    WaterSpan w = within_side(within_side(within_side(s, a.x, a.y), b.x, b.y), c.x, c.y);
    real middle = clamp(real(0.5) * (w.near + w.far), real(0), real(1));
    real3 side = real3(side_at(a, middle), side_at(b, middle), side_at(c, middle));
    real least = min(min(side.x, side.y), side.z), length = least > real(0) ? max(w.far - w.near, real(0)) : real(0);
    return length / max(side.x + side.y + side.z, real(1e-30));
}

// For sections that turn either way; beams fold. `s` in t, of the part from t = `near` on, `step` long.
KERNEL real density_in_part(WaterSpan s, real near, real step, real3 a, real3 b, real3 c) {
    WaterSpan w;
    w.near = clamp((s.near - near) / step, real(0), real(1));
    w.far = clamp((s.far - near) / step, real(0), real(1));
    return step * (density_along(w, a, b, c) + density_along(w, -a, -b, -c));
}

// Parts of the way of a ray that runs along a beam, for a picture of `samples` sections of a chord.
KERNEL int parts_along(int samples) {
    return 8 + 8 * samples;
}
