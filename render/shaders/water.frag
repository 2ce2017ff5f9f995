// The water's surface: what it reflects and what is seen through it, from above or from below.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "render/shaders/includes.glsl"
#include "render/shaders/sky.glsl"
#include "render/shaders/light.glsl"
#include "render/shaders/water.glsl"
#include "render/shaders/surface_cells.glsl"

layout(location = 0) out vec4 drawn;

struct Point {
    vec3 place;
    float distance;  // from the eye, m
    float width;     // of the pixel there, across the sight, m
    vec2 slope;
    float variance;
};

Point point_at(Sight a) {
    float t = way_of_fragment(gl_FragCoord.w);
    Point q;
    q.place = eye() + t * a.r;
    q.distance = t * a.metres;
    q.width = t * pixel_width();
    vec2 level = length(a.d.xy) > 1e-4 ? normalize(a.d.xy) : vec2(1, 0);
    vec2 u = cells_of(q.place.xy);
    float half_width = 0.5 * q.width;
    Slopes slopes = slopes_at(cells_around(u), level * half_width / max(abs(a.d.z), 0.02),
                              vec2(-level.y, level.x) * half_width);
    q.slope = slopes.mean;
    q.variance = slopes.variance;
    return q;
}

float sun_transmittance(float cos_i) {
    float cos_t = sqrt(max(0, 1 - (1 - cos_i * cos_i) / (s.index * s.index)));
    float t = fresnel_transmittance(cos_i, cos_t, s.index);
    return t + (1 - s.fresnel) * (1 - t);
}

vec3 from_above(Point q, vec3 d) {
    vec3 normal = normal_of(visible_slope(-d, q.slope, q.variance, 1));
    SightRefraction refracted = refract_sight(d, normal, s.index, s.fresnel);
    vec3 below = seen_in_water(q.place, refracted.direction, q.width);
    if (overlay == OVERLAY_FLOOR || overlay == OVERLAY_ERROR) return below;
    vec3 sky = sky_above(reflect_sight(d, normal));
    SunSeen sun = sun_in_reflection(-d, to_sun(), q.slope, q.variance, s.sun_radius);
    float glint = s.sun_irradiance * sun.radiance * (1 - sun_transmittance(sun.cos_h));
    return refracted.transmittance / (s.index * s.index) * below + (1 - refracted.transmittance) * sky + glint;
}

vec3 from_below(Point q, vec3 d) {
    vec3 normal = -normal_of(visible_slope(-d, q.slope, q.variance, -1));
    SightRefraction refracted = refract_sight(d, normal, 1 / s.index, s.fresnel);
    vec3 mirrored = reflect_sight(d, normal);
    mirrored.z = min(mirrored.z, -0.003);
    vec3 below = seen_in_water(q.place, mirrored, q.width);
    vec3 sky = sky_above(refracted.direction);
    SunSeen sun = sun_in_refraction(-d, to_sun(), q.slope, q.variance, s.sun_radius, max(s.index, 1.0001));
    float shine = s.sun_irradiance * sun.radiance * sun_transmittance(sun.cos_h);
    return s.index * s.index * (refracted.transmittance * sky + shine) + (1 - refracted.transmittance) * below;
}

void main() {
    Sight a = sight(gl_FragCoord.xy);
    Point q = point_at(a);
    if (uneven && !is_wet(cells_of(q.place.xy), 0)) discard;
    if (overlay == OVERLAY_ELEVATION) {
        drawn = exposed(overlay_colour(q.place.z));
        return;
    }
    vec3 radiance = in_water ? from_below(q, a.d) : from_above(q, a.d);
    drawn = exposed(through_water(radiance, a.d, q.distance));
}
