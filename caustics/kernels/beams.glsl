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

KERNEL BeamEdge beam_edge(real3 corner, real2 travel) {
    BeamEdge e;
    e.at = real2(corner.x + corner.z * travel.x, corner.y + corner.z * travel.y);
    e.travel = travel;
    return e;
}

// V of a beam's mean travel.
KERNEL real2 speed_past(real2 mean, real3 r) {
    return real2(r.z * mean.x - r.x, r.z * mean.y - r.y);
}

// Four numbers of an edge: at.V and at x V, and how the edge leaves the mean, off.V and off x V with
// off = travel - mean.
struct EdgeNumbers {
    real along;
    real across;
    real leads;
    real warps;
};

KERNEL EdgeNumbers edge_numbers(real2 at, real2 off, real2 v) {
    EdgeNumbers n;
    n.along = at.x * v.x + at.y * v.y;
    n.across = at.x * v.y - at.y * v.x;
    n.leads = off.x * v.x + off.y * v.y;
    n.warps = off.x * v.y - off.y * v.x;
    return n;
}

// The same as they depend on the ray: linear, dot(form, r).
struct EdgeForms {
    real3 along;
    real3 across;
    real3 leads;
    real3 warps;
};

KERNEL EdgeForms edge_forms(BeamEdge e, real2 mean) {
    real2 off = real2(e.travel.x - mean.x, e.travel.y - mean.y);
    EdgeNumbers x = edge_numbers(e.at, off, speed_past(mean, real3(real(1), real(0), real(0))));
    EdgeNumbers y = edge_numbers(e.at, off, speed_past(mean, real3(real(0), real(1), real(0))));
    EdgeNumbers down = edge_numbers(e.at, off, speed_past(mean, real3(real(0), real(0), real(1))));
    EdgeForms f;
    f.along = real3(x.along, y.along, down.along);
    f.across = real3(x.across, y.across, down.across);
    f.leads = real3(x.leads, y.leads, down.leads);
    f.warps = real3(x.warps, y.warps, down.warps);
    return f;
}

// |r| times the cosine between the light's way, `path` metres per metre of descent, and the way to the eye.
KERNEL real towards_eye(real2 mean, real path, real3 r) {
    return -(mean.x * r.x + mean.y * r.y + r.z) / path;
}

// The section's corner on an edge: when the ray is abreast of it (the paper's plane section), and how far it then lies
// beside the ray, times |V|. The warp is followed where the ray is in the water, from `near` to `far`. Rays that run
// along the beam are left to beams_along.glsl.
struct SectionCorner {
    real time;
    real across;
};

KERNEL SectionCorner section_corner(EdgeNumbers e, real inverse_speed2, real down, real near, real far) {
    real descent = clamp(-e.along * inverse_speed2, near, far) * down;
    SectionCorner c;
    c.time = -(e.along + descent * e.leads) * inverse_speed2;
    c.across = e.across + descent * e.warps;
    return c;
}

// The corners of a cell's section, on its edges counted around it: beam 0 has corners 0, 1, 2, beam 1 has 0, 2, 3.
struct CellCorners {
    SectionCorner c0;
    SectionCorner c1;
    SectionCorner c2;
    SectionCorner c3;
};

KERNEL CellCorners cell_corners(EdgeNumbers e0, EdgeNumbers e1, EdgeNumbers e2, EdgeNumbers e3, real2 v, real down,
                                real near, real far) {
    real inverse = real(1) / max(v.x * v.x + v.y * v.y, real(1e-12));
    CellCorners c;
    c.c0 = section_corner(e0, inverse, down, near, far);
    c.c1 = section_corner(e1, inverse, down, near, far);
    c.c2 = section_corner(e2, inverse, down, near, far);
    c.c3 = section_corner(e3, inverse, down, near, far);
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

// How far a chord reaches beyond the part of the ray that is looked at, or above the depth `lowest_lid` below the eye;
// above 0 where it is to be cut.
KERNEL real chord_excess(BeamChord c, real near, real far, real down, real lowest_lid) {
    real shallow = min(down * c.begin, down * c.end);
    return c.density * max(max(near - c.begin, c.end - far), lowest_lid - shallow);
}

// The same of a beam that ends on uneven ground: how far below the depth `highest_end`.
KERNEL real chord_excess_below(BeamChord c, real down, real highest_end) {
    return c.density * (max(down * c.begin, down * c.end) - highest_end);
}

// A plane that bounds a beam, through the three corners of one of its ends. A ray goes towards its outside at
// dot(outward, r); the eye is `distance` metres inside of it.
struct BeamLid {
    real3 outward;
    real distance;
};

// On the surface: corners relative to the eye, z up, counter-clockwise as seen from above.
KERNEL BeamLid upper_lid(real3 a, real3 b, real3 c) {
    real3 normal = unit(cross(b - a, c - a));
    BeamLid lid;
    lid.outward = real3(normal.x, normal.y, -normal.z);
    lid.distance = dot(normal, a);
    return lid;
}

// Where the light ends, either way round, for beams fold: its outside is where the light, along `light`, would go on.
// Where the corners are in line, or the light grazes their plane, the plane is level.
KERNEL BeamLid lower_lid(real3 a, real3 b, real3 c, real3 light) {
    real3 normal = cross(b - a, c - a);
    real onwards = dot(normal, light);
    bool clear = onwards * onwards > real(0.01) * dot(normal, normal) * dot(light, light);
    real middle = (a.z + b.z + c.z) * (real(1) / real(3));
    real3 outside = clear ? unit(onwards < real(0) ? -normal : normal) : real3(real(0), real(0), real(-1));
    BeamLid lid;
    lid.outward = real3(outside.x, outside.y, -outside.z);
    lid.distance = clear ? dot(outside, a) : -middle;
    return lid;
}

// The part of a ray, t from `near` to `far`, inside a lid that it approaches at `speed`.
KERNEL WaterSpan within_lid(WaterSpan s, real speed, real distance) {
    real cover = distance / (abs(speed) < real(1e-12) ? real(1e-12) : speed);
    WaterSpan w;
    w.near = speed < real(0) ? max(s.near, cover) : s.near;
    w.far = speed < real(0) ? s.far : min(s.far, cover);
    return w;
}

// What of a chord lies in that part.
KERNEL BeamChord cut_chord(BeamChord c, WaterSpan s) {
    BeamChord kept;
    kept.density = c.density * part_within(c.begin, c.end, s.near, s.far);
    kept.begin = clamp(c.begin, s.near, s.far);
    kept.end = clamp(c.end, s.near, s.far);
    return kept;
}

// Part k of `parts` of a chord that are equally long. A chord that the ray passes by is not cut: in parts of it beyond the
// part of the ray that is looked at the ray might meet the beam.
KERNEL WaterSpan chord_part(BeamChord whole, WaterSpan ray, int k, int parts) {
    real begin = clamp(whole.begin, ray.near, max(ray.near, ray.far));
    real end = clamp(whole.end, ray.near, max(ray.near, ray.far));
    real step = (end - begin) / real(parts);
    WaterSpan s;
    s.near = begin + real(k) * step;
    s.far = k + 1 == parts ? end : begin + real(k + 1) * step;
    return s;
}

// What reaches the eye of the light that a chord scatters towards it, from the chord's middle. `density` holds flux and
// phase function.
KERNEL real light_from_chord(BeamChord c, real extinction, real path, real above, real down, real near, real length) {
    real middle = real(0.5) * (c.begin + c.end);
    real left = beam_attenuation(extinction, path, above, down, near, length, middle);
    return c.density > real(0) ? length * c.density * left : real(0);
}
