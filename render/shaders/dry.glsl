// Walls, deck and ground above the water: radiance of what sun and sky send there. `lit` is the part of the sun's light
// that arrives. After light.glsl.

vec3 sky_irradiance() { return vec3(s.sky_r, s.sky_g, s.sky_b); }

// What comes up from the water, as irradiance.
vec3 irradiance_from_water() {
    return vec3(ambient_from_water(s.sky_r, s.up_r, s.r_ext, s.r_int),
                ambient_from_water(s.sky_g, s.up_g, s.r_ext, s.r_int),
                ambient_from_water(s.sky_b, s.up_b, s.r_ext, s.r_int));
}

// And from level ground.
vec3 irradiance_from_ground() {
    return vec3(s.mean_r, s.mean_g, s.mean_b) * (s.sun_irradiance * max(0, s.sun_z) + sky_irradiance());
}

// A wall above the water: the sun, half of the sky, and half of what comes up from the water.
vec3 dry_wall(int wall, vec3 place, vec2 widths, float lit) {
    float along = wall < 2 ? place.y - s.y0 : place.x - s.x0;
    float sun = lit * s.sun_irradiance * max(0, dot(wall_inward(wall), to_sun()));
    vec3 albedo = vec3(s.wall_r, s.wall_g, s.wall_b) * finish(wall_pattern, vec2(along, place.z), widths, s.wall_side);
    return albedo * (sun + 0.5 * (sky_irradiance() + irradiance_from_water())) * (1 / pi);
}

vec3 deck(vec3 place, vec2 widths, float lit) {
    vec3 albedo = vec3(s.deck_r, s.deck_g, s.deck_b) * finish(deck_pattern, vec2(place), widths, s.deck_side);
    return albedo * (lit * s.sun_irradiance * max(0, s.sun_z) + sky_irradiance()) * (1 / pi);
}

// Sun and sky on the slope, and what level ground around it sends up.
vec3 dry_ground(vec3 place, vec2 slope, vec2 widths, float lit) {
    vec3 normal = normal_of(slope);
    vec3 e = vec3(lit * s.sun_irradiance * max(0, dot(normal, to_sun()))) + 0.5 * (1 + normal.z) * sky_irradiance() +
             0.5 * (1 - normal.z) * irradiance_from_ground();
    return albedo_at(-1, vec2(place), widths) * e * (1 / pi);
}
