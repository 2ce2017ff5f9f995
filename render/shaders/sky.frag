// The sky and the sun's disc where nothing is before them.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "render/shaders/includes.glsl"
#include "render/shaders/sky.glsl"
#include "render/shaders/light.glsl"
#include "render/shaders/water.glsl"

layout(location = 0) out vec4 drawn;

// What of a pixel the sun's disc covers.
float disc_part(Sight a) {
    float from_middle = length(cross(a.d, to_sun()));
    float half_pixel = 0.5 * pixel_width() / (a.metres * a.metres);
    float part = clamp(0.5 + (s.sun_radius - from_middle) / (2 * half_pixel), 0, 1);
    return dot(a.d, to_sun()) > 0 ? part : 0;
}

// Of the floor where it meets the surface in the distance.
vec3 far_floor() {
    vec3 sun = s.entering * exp(-(s.extinction + colours()) * s.path * s.depth);
    return vec3(s.mean_r, s.mean_g, s.mean_b) * (sun + vec3(s.ambient_r, s.ambient_g, s.ambient_b)) / pi;
}

void main() {
    Sight a = sight(gl_FragCoord.xy);
    vec3 radiance = sky_at(a.d);
    if (in_water && !outside) {
        drawn = exposed(through_water(far_floor(), a.d, far_away));
        return;
    }
    if (a.d.z > 0) radiance += disc_part(a) * s.sun_irradiance / (pi * s.sun_radius * s.sun_radius);
    drawn = exposed(radiance);
}
