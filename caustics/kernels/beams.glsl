// Beams of light under water: Liktor & Dachsbacher, "Real-Time Volumetric Caustics with Projected Light Beams" (2010),
// after Ernst, Akenine-Moeller & Jensen, "Interactive Rendering of Caustics using Interpolated Warped Volumes" (2005).
// A beam is the light through one triangle of the surface: corners v_i, directions d_i of the light behind them. Its
// section at height y below the triangle has the corners v_i + y d_i, with d_i scaled to advance by 1 along y.

// Twice the signed area of the section as (a, b, c) of a y^2 + b y + c. k_i = v_i - v_0 and l_i = d_i - d_0 in the
// section's plane; a real2 holds x and z of beam space. The paper prints l1z l1x for the first product of a.
KERNEL real3 area_polynomial(real2 k1, real2 k2, real2 l1, real2 l2) {
    return real3(l1.y * l2.x - l1.x * l2.y,
                 k1.y * l2.x - k1.x * l2.y + l1.y * k2.x - l1.x * k2.y,
                 k1.y * k2.x - k1.x * k2.y);
}

KERNEL real section_area(real3 area, real y) {
    return abs((area.x * y + area.y) * y + area.z);
}

// Beam space: origin v_0, x along the edge v_0 - v_1, y along the triangle's normal into the water, z = x cross y.
struct BeamSpace {
    real3 origin;
    real3 x;
    real3 y;
    real3 z;
    real2 k1;
    real2 k2;
    real2 d0;
    real2 l1;
    real2 l2;
    real3 area;
};

KERNEL real3 unit(real3 v) {
    return v * (real(1) / sqrt(dot(v, v)));
}

// x and z of a direction in beam space, scaled to y = 1.
KERNEL real2 advance_in(BeamSpace b, real3 d) {
    real scale = real(1) / dot(b.y, d);
    return real2(dot(b.x, d) * scale, dot(b.z, d) * scale);
}

// x and z of a place in beam space.
KERNEL real2 place_in(BeamSpace b, real3 p) {
    real3 away = p - b.origin;
    return real2(dot(b.x, away), dot(b.z, away));
}

KERNEL BeamSpace beam_space(real3 v0, real3 v1, real3 v2, real3 d0, real3 d1, real3 d2) {
    BeamSpace b;
    b.origin = v0;
    b.x = unit(v0 - v1);
    real3 normal = unit(cross(v1 - v0, v2 - v0));
    b.y = dot(normal, d0) < real(0) ? -normal : normal;
    b.z = cross(b.x, b.y);
    b.k1 = place_in(b, v1);
    b.k2 = place_in(b, v2);
    b.d0 = advance_in(b, d0);
    b.l1 = advance_in(b, d1) - b.d0;
    b.l2 = advance_in(b, d2) - b.d0;
    b.area = area_polynomial(b.k1, b.k2, b.l1, b.l2);
    return b;
}

// Irradiance (W/m2) on a plane that faces the beam: flux (W) over the section's area, of which the light sees the part
// cosine = |d.n| / |d|. On a plane that light meets at cosine', times that.
KERNEL real irradiance_across(real flux, real twice_area, real cosine) {
    return real(2) * flux / (twice_area * cosine);
}

// In pictures all sections are horizontal, so that neighbours share their sides exactly and no ray meets a gap or an
// overlap. An edge of a beam, seen by an eye at the origin of t r, r = (x, y, -down): at the eye's depth it passes the
// horizontal place `at` and goes on by `travel` metres per metre of descent. Relative to the ray at the same depth it
// moves as U(t) = at + t V, V = down travel - r_xy. A ray is in the beam where the origin is in the triangle U_i(t).
struct BeamEdge {
    real2 at;
    real2 travel;
};

// Four numbers of an edge, linear in (r_x, r_y, down), with the V of the beam's mean travel: at.V and at x V, and how the
// edge leaves the mean, (travel - mean).V and (travel - mean) x V.
struct EdgeForms {
    real3 along;
    real3 across;
    real3 leads;
    real3 warps;
};

KERNEL EdgeForms edge_forms(BeamEdge e, real2 mean) {
    real2 off = real2(e.travel.x - mean.x, e.travel.y - mean.y);
    EdgeForms f;
    f.along = real3(-e.at.x, -e.at.y, e.at.x * mean.x + e.at.y * mean.y);
    f.across = real3(e.at.y, -e.at.x, e.at.x * mean.y - e.at.y * mean.x);
    f.leads = real3(-off.x, -off.y, off.x * mean.x + off.y * mean.y);
    f.warps = real3(off.y, -off.x, off.x * mean.y - off.y * mean.x);
    return f;
}

struct EdgeNumbers {
    real along;
    real across;
    real leads;
    real warps;
};

// The section's corner on an edge: when the ray is abreast of it (the paper's plane section), and how far it then lies
// beside the ray, times |V|. The warp is followed where the ray is in the water, from `near` to `far`; where the ray runs
// along the beam within 2 degrees and is abreast of nothing or of everything, it is taken near the eye.
struct SectionCorner {
    real time;
    real across;
};

KERNEL SectionCorner section_corner(EdgeNumbers e, real inverse_speed2, real down, real near, real far) {
    real descent = clamp(-e.along * min(inverse_speed2, real(1000)), near, far) * down;
    SectionCorner c;
    c.time = -(e.along + descent * e.leads) * inverse_speed2;
    c.across = e.across + descent * e.warps;
    return c;
}

// The part of the ray inside the section's triangle, t from `begin` to `end`, and the length of that part over twice the
// area, both in the plane of (t, across): `density`, which stays finite where the beam folds and the area is zero. One
// corner is alone on its side of the ray; the ray crosses the two sides that meet there. Zero where it passes by.
struct BeamChord {
    real density;
    real begin;
    real end;
};

KERNEL real nudged(real x) {
    return abs(x) < real(1e-18) ? real(1e-18) : x;
}

// `divisor` > 0 is something else that the caller divides by: `density` is divided by it, at the cost of no division.
KERNEL BeamChord beam_chord(SectionCorner c0, SectionCorner c1, SectionCorner c2, real divisor) {
    // A corner on the ray counts to one side. One comparison a choice: GCC vectorises those, and not logic.
    real h0 = nudged(c0.across);
    real h1 = nudged(c1.across);
    real h2 = nudged(c2.across);
    real same01 = h0 * h1;
    real same02 = h0 * h2;
    real h = same01 > real(0) ? h2 : (same02 > real(0) ? h1 : h0);
    real t = same01 > real(0) ? c2.time : (same02 > real(0) ? c1.time : c0.time);
    real hb = same01 > real(0) ? h1 : h2;
    real tb = same01 > real(0) ? c1.time : c2.time;
    real ha = same01 > real(0) ? h0 : (same02 > real(0) ? h0 : h1);
    real ta = same01 > real(0) ? c0.time : (same02 > real(0) ? c0.time : c1.time);
    real da = ha - h;
    real db = hb - h;
    // da and db have the same sign where the ray meets the triangle.
    real divided = -h / (max(da * db, real(1e-30)) * divisor);
    real scale = divided * divisor;
    real a = t + (ta - t) * db * scale;
    real b = t + (tb - t) * da * scale;
    BeamChord chord;
    chord.density = h * ha < real(0) ? abs(divided) : real(0);
    chord.begin = min(a, b);
    chord.end = max(a, b);
    return chord;
}

// The chords of two beams that share a side as one; a chord of density 0 does not count.
KERNEL BeamChord joined_chord(BeamChord a, BeamChord b) {
    BeamChord whole;
    whole.density = a.density + b.density;
    whole.begin = min(a.density > real(0) ? a.begin : b.begin, b.density > real(0) ? b.begin : a.begin);
    whole.end = max(a.density > real(0) ? a.end : b.end, b.density > real(0) ? b.end : a.end);
    return whole;
}

// What is left of the light at t: from the surface, `above` metres over the eye's depth, on a slanting path (metres per
// metre of descent), then to the eye. `length` = |r|; the ray enters the water at `near`.
KERNEL real beam_attenuation(real extinction, real path, real above, real down, real near, real length, real t) {
    return exp(-extinction * (path * (above + down * t) + (t - near) * length));
}

// The part of a ray, t from `near` to `far`, in a box of water around or before the eye: corners relative to the eye, in
// (x, y, depth) as r is. far < near where it passes by.
struct WaterSpan {
    real near;
    real far;
};

KERNEL WaterSpan water_span(real3 r, real3 low, real3 high) {
    real sx = real(1) / (abs(r.x) < real(1e-12) ? real(1e-12) : r.x);
    real sy = real(1) / (abs(r.y) < real(1e-12) ? real(1e-12) : r.y);
    real sz = real(1) / (abs(r.z) < real(1e-12) ? real(1e-12) : r.z);
    WaterSpan s;
    s.near = max(max(min(low.x * sx, high.x * sx), min(low.y * sy, high.y * sy)),
                 max(min(low.z * sz, high.z * sz), real(0)));
    s.far = min(min(max(low.x * sx, high.x * sx), max(low.y * sy, high.y * sy)), max(low.z * sz, high.z * sz));
    return s;
}

// What of a chord lies from `near` to `far`, as a part of it. A chord without length counts whole or not at all.
KERNEL real part_within(real begin, real end, real near, real far) {
    real hair = real(1e-6) * (real(1) + abs(begin));
    real within = min(end + hair, far) - max(begin - hair, near);
    return clamp(within / (end - begin + real(2) * hair), real(0), real(1));
}
