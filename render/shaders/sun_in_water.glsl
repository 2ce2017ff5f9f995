// The sun seen in a place of the surface. After scene.glsl.

float sun_transmittance(float cos_i) {
    float cos_t = sqrt(max(0, 1 - (1 - cos_i * cos_i) / (s.index * s.index)));
    float t = fresnel_transmittance(cos_i, cos_t, s.index);
    return t + (1 - s.fresnel) * (1 - t);
}

// Its radiance reflected, along the sight's direction d from above.
float glint(vec3 d, vec2 slope, float variance) {
    SunSeen sun = sun_in_reflection(-d, to_sun(), slope, variance, s.sun_radius);
    return s.sun_irradiance * sun.radiance * (1 - sun_transmittance(sun.cos_h));
}

// And refracted, along d from below, before n^2.
float shine(vec3 d, vec2 slope, float variance) {
    SunSeen sun = sun_in_refraction(-d, to_sun(), slope, variance, s.sun_radius, max(s.index, 1.0001));
    return s.sun_irradiance * sun.radiance * sun_transmittance(sun.cos_h);
}
