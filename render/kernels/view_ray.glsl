// A ray of sight at the water surface, and the sun seen in it. Directions of travel and normals are unit vectors; slopes
// are those of the surface; n is the index of the side that the ray goes to over that which it comes from. Include after
// caustics/kernels/interface.glsl.

// What a turn of the ray and of the normal, small and across them, turns the refracted direction by; the derivative of
// Snell's formula (refract_ray). Cosines of refraction below a hundredth count as that.
KERNEL real3 turn_refracted(real3 d, real3 normal, real n, real3 turn_d, real3 turn_normal) {
    real inv_n = real(1) / n;
    real cos_i = max(real(0), -dot(d, normal));
    real cos_t = sqrt(max(real(1e-4), real(1) - (real(1) - cos_i * cos_i) * inv_n * inv_n));
    real turn_i = -(dot(turn_d, normal) + dot(d, turn_normal));
    real turn_t = cos_i * inv_n * inv_n * turn_i / cos_t;
    return inv_n * turn_d + (turn_i * inv_n - turn_t) * normal + (cos_i * inv_n - cos_t) * turn_normal;
}

KERNEL real3 turn_reflected(real3 d, real3 normal, real3 turn_d, real3 turn_normal) {
    real turn_i = dot(turn_d, normal) + dot(d, turn_normal);
    return turn_d - real(2) * (turn_i * normal + dot(d, normal) * turn_normal);
}

// What a change of slope turns the unit normal by.
KERNEL real3 turn_of_normal(real3 normal, real2 change) {
    real3 v = real3(-change.x * normal.z, -change.y * normal.z, 0);
    return v - dot(v, normal) * normal;
}

// A small move, along d onto the plane across `normal`.
KERNEL real3 moved_onto(real3 move, real3 d, real3 normal) {
    real along = dot(d, normal);
    along = abs(along) < real(1e-3) ? real(1e-3) : along;
    return move - (dot(move, normal) / along) * d;
}

// Unit normal, upwards.
KERNEL real3 normal_of(real2 slope) {
    real scale = real(1) / sqrt(real(1) + dot(slope, slope));
    return real3(-slope.x * scale, -slope.y * scale, scale);
}

// How large a horizontal piece of the surface looks, per area, where slopes within a pixel are spread around their mean by
// `variance` along each axis: the mean of max(0, v.(-slope, 1)) over a normal distribution, to some 10 %. `up` is 1 seen
// from above, -1 from below.
KERNEL real visible_part(real3 to_eye, real2 slope, real variance, real up) {
    real facing = up * (to_eye.z - slope.x * to_eye.x - slope.y * to_eye.y);
    real spread = real(0.16) * variance * (to_eye.x * to_eye.x + to_eye.y * to_eye.y);
    return sqrt(max(real(1e-12), facing * facing + spread));
}

// The mean slope of what is seen of it: what leans towards the eye looks larger. Exact (m - variance v_xy / facing) where
// the surface faces the eye by more than its spread, and where it is seen edge on (1.2533 standard deviations).
KERNEL real2 visible_slope(real3 to_eye, real2 slope, real variance, real up) {
    real2 across = real2(to_eye.x, to_eye.y);
    real facing = up * (to_eye.z - dot(slope, across));
    real edge = real(0.6366) * variance * dot(across, across);
    real shift = up * variance / sqrt(max(real(1e-12), facing * facing + edge));
    return slope - shift * across;
}

// Probability density of a slope, per unit of slope along both axes.
KERNEL real slope_density(real2 slope, real2 mean, real variance) {
    real2 off = slope - mean;
    return exp(max(real(-80), real(-0.5) * dot(off, off) / variance)) / (real(6.283185307179586) * variance);
}

// Radiance of the sun reflected by the surface, before the reflectance, per E0 (1/sr): facets of the one slope that shows
// the sun, by the density of that slope (Cox & Munk 1954; dw_half = dw_sun / (4 v.h), d slope = dw_half / h_z^3). The
// sun's disc, of half-angle `radius`, widens the slopes by what its own width asks for, so that no energy is lost and none
// gained. cos_h of the result is the cosine of incidence.
struct SunSeen {
    real radiance;
    real cos_h;
};

KERNEL SunSeen sun_in_reflection(real3 to_eye, real3 to_sun, real2 slope, real variance, real radius) {
    SunSeen seen;
    real3 h = to_eye + to_sun;
    h = h * (real(1) / sqrt(max(real(1e-12), dot(h, h))));
    real hz = max(real(0.05), h.z);
    seen.cos_h = max(real(1e-3), dot(to_eye, h));
    real per_slope = real(1) / (real(4) * seen.cos_h * hz * hz * hz);
    real spread = variance + real(0.25) * radius * radius * per_slope;
    real density = slope_density(real2(-h.x / hz, -h.y / hz), slope, spread);
    seen.radiance = h.z > real(0.05) && to_sun.z > real(0)
                        ? density * per_slope * seen.cos_h / (hz * visible_part(to_eye, slope, spread, real(1)))
                        : real(0);
    return seen;
}

// The same through the surface from below, before the transmittance and n^2: dw_half = dw_sun |l.h| / (n v.h + l.h)^2
// (Walter et al., "Microfacet models for refraction through rough surfaces", 2007, eq. 17). n > 1 is the water's index.
KERNEL SunSeen sun_in_refraction(real3 to_eye, real3 to_sun, real2 slope, real variance, real radius, real n) {
    SunSeen seen;
    real3 h = real3(0, 0, 0) - n * to_eye - to_sun;
    real length2 = max(real(1e-12), dot(h, h));
    h = h * (real(1) / sqrt(length2));
    real hz = max(real(0.05), h.z);
    seen.cos_h = max(real(1e-3), dot(to_sun, h));
    real per_slope = seen.cos_h / (length2 * hz * hz * hz);
    real spread = variance + real(0.25) * radius * radius * per_slope;
    real density = slope_density(real2(-h.x / hz, -h.y / hz), slope, spread);
    real down = max(real(0), -dot(to_eye, h));
    seen.radiance = h.z > real(0.05) && dot(to_sun, h) > real(0) && to_sun.z > real(0)
                        ? density * per_slope * down / (hz * visible_part(to_eye, slope, spread, real(-1)))
                        : real(0);
    return seen;
}
