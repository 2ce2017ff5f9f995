// Ground: dry in sun and sky, or below the water for a camera in it.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "render/shaders/includes.glsl"
#include "render/shaders/light.glsl"
#include "render/shaders/water.glsl"
#include "render/shaders/surface_cells.glsl"

layout(location = 0) out vec4 drawn;

// Sun and sky on the slope, and what level ground around it sends up.
vec3 dry_ground(vec3 place, vec2 slope, vec2 widths) {
    vec3 sky = vec3(s.sky_r, s.sky_g, s.sky_b), mean = vec3(s.mean_r, s.mean_g, s.mean_b);
    vec3 normal = normal_of(slope);
    vec3 around = mean * (s.sun_irradiance * max(0, s.sun_z) + sky);
    vec3 e = s.sun_irradiance * max(0, dot(normal, to_sun())) + 0.5 * (1 + normal.z) * sky + 0.5 * (1 - normal.z) * around;
    return albedo_at(-1, place.xy, widths) * e * (1 / pi);
}

void main() {
    Sight a = sight(gl_FragCoord.xy);
    float t = way_of_fragment(gl_FragCoord.w);
    vec3 place = eye() + t * a.r;
    float width = t * pixel_width();
    vec2 widths = min(fwidth(place.xy), vec2(width / max(abs(a.d.z), 0.02)));
    if (!in_water) {
        vec2 u = cells_of(place.xy);
        if (is_wet(u, width)) discard;  // a pixel further than the water, so that no gap is left between them
        drawn = exposed(dry_ground(place, ground_around(u).slope, widths));
        return;
    }
    drawn = exposed(through_water(radiance_in_water(-1, place, width, widths), a.d, t * a.metres));
}
