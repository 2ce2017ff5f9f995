// A ray at the boundary of two media. Directions of travel and normals are unit vectors; the normal is on the side from
// which the ray comes; n is the index of the side that the ray goes to over that which it comes from. Include after
// caustics/kernels/optics.glsl.

struct RayRefraction {
    real3 direction;     // of travel beyond the boundary; along it where all is reflected
    real transmittance;  // Fresnel, or 1 without it; 0 where all is reflected
};

// Snell: t = d/n + (cos_i/n - cos_t) N.
KERNEL RayRefraction refract_ray(real3 d, real3 normal, real n, real fresnel) {
    RayRefraction r;
    real inv_n = real(1) / n;
    real cos_i = max(real(0), -dot(d, normal));
    real cos2_t = real(1) - (real(1) - cos_i * cos_i) * inv_n * inv_n;
    real cos_t = sqrt(max(real(0), cos2_t));
    r.direction = inv_n * d + (cos_i * inv_n - cos_t) * normal;
    real t = min(real(1), fresnel_transmittance(cos_i, cos_t, n));  // near n = 1 it may round to more
    r.transmittance = cos2_t > real(0) ? t + (real(1) - fresnel) * (real(1) - t) : real(0);
    return r;
}

KERNEL real3 reflect_ray(real3 d, real3 normal) {
    return d - real(2) * dot(d, normal) * normal;
}
