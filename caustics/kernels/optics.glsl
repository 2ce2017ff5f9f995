// Light at the water surface and below it. Symbols: s = unit direction in which the sun's light travels (s.z < 0),
// N = unit normal of the surface (N.z > 0), n = refractive index of the water (that of air is 1), n >= 1.

// Cosine of incidence over N_z: power entering per unit horizontal area is E0 times this. Zero where the surface faces away.
KERNEL real incident_factor(real3 s, real2 slope) {
    return max(real(0), s.x * slope.x + s.y * slope.y - s.z);
}

// Unpolarised Fresnel transmittance from the cosines on both sides. Grazing light keeps its few per mille to rounding,
// which 1 - reflectance would not, and where both cosines are 0 (n = 1, light along the surface) none enters.
KERNEL real fresnel_transmittance(real cos_i, real cos_t, real n) {
    real s = max(real(1e-15), cos_i + n * cos_t);
    real p = max(real(1e-15), n * cos_i + cos_t);
    return real(2) * n * cos_i * cos_t * (real(1) / (s * s) + real(1) / (p * p));
}

// Beer-Lambert: what is left after `path` metres of extinction c (1/m).
KERNEL real beer_lambert(real c, real path) {
    return exp(-c * path);
}

struct Refraction {
    real2 travel;        // horizontal metres per metre of descent: t_xy / (-t_z)
    real path;           // metres of path per metre of descent: 1 / (-t_z)
    real incident;       // cos_i / N_z
    real transmittance;  // Fresnel
};

// Snell: t = s/n + (cos_i/n - cos_t) N.
KERNEL Refraction refract_sun(real3 s, real2 slope, real n, real fresnel) {
    Refraction r;
    r.incident = incident_factor(s, slope);
    real nz = real(1) / sqrt(real(1) + slope.x * slope.x + slope.y * slope.y);
    real cos_i = r.incident * nz;
    real inv_n = real(1) / n;
    real cos_t = sqrt(max(real(0), real(1) - (real(1) - cos_i * cos_i) * inv_n * inv_n));
    real along = (cos_i * inv_n - cos_t) * nz;
    real descent = -(s.z * inv_n + along);
    r.path = real(1) / descent;
    r.travel = real2((s.x * inv_n - along * slope.x) * r.path, (s.y * inv_n - along * slope.y) * r.path);
    real t = fresnel_transmittance(cos_i, cos_t, n);
    r.transmittance = t + (real(1) - fresnel) * (real(1) - t);
    return r;
}

// The sun reflected by the surface, r = s + 2 cos_i N, in the same words with up for down: travel and path per metre of
// rise, and in the place of the transmittance the reflectance. Path and travel are 0 where r rises by less than a
// hundredth of its way: such light meets other water.
KERNEL Refraction reflect_sun(real3 s, real2 slope, real n, real fresnel) {
    Refraction r;
    r.incident = incident_factor(s, slope);
    real nz = real(1) / sqrt(real(1) + slope.x * slope.x + slope.y * slope.y);
    real cos_i = r.incident * nz;
    real cos_t = sqrt(max(real(0), real(1) - (real(1) - cos_i * cos_i) / (n * n)));
    real along = real(2) * cos_i * nz;
    real rise = s.z + along;
    r.path = rise > real(0.01) ? real(1) / rise : real(0);
    r.travel = real2((s.x - along * slope.x) * r.path, (s.y - along * slope.y) * r.path);
    r.transmittance = fresnel * (real(1) - fresnel_transmittance(cos_i, cos_t, n));
    return r;
}
