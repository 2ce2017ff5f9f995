// The sky's radiance towards the eye, without the sun's disc.

vec3 sky_at(vec3 d) {
    if (uniform_sky) return vec3(s.sky_scale);
    vec3 above = s.sky_scale * clear_sky(d.z, dot(d, to_sun())) * sky_tint(d.z);
    return mix(vec3(s.earth_r, s.earth_g, s.earth_b), above, clamp(0.5 + 100 * d.z, 0, 1));
}

// Of a ray that the surface sends up: one that would go down meets other water, and is taken for the horizon's.
vec3 sky_above(vec3 d) {
    d.z = max(d.z, 0.01);
    return sky_at(d);
}
