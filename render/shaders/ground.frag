// Ground: dry in sun and sky, or below the water for a camera in it.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "render/shaders/includes.glsl"
#include "render/shaders/light.glsl"
#include "render/shaders/water.glsl"
#include "render/shaders/surface_cells.glsl"
#include "render/shaders/dry.glsl"

layout(location = 0) out vec4 drawn;

void main() {
    Sight a = sight(gl_FragCoord.xy);
    float t = way_of_fragment(gl_FragCoord.w);
    vec3 place = eye() + t * a.r;
    float width = t * pixel_width();
    vec2 widths = min(fwidth(place.xy), vec2(width / max(abs(a.d.z), 0.02)));
    if (!in_water) {
        vec2 u = cells_of(place.xy);
        if (is_wet(u, width)) discard;  // a pixel further than the water, so that no gap is left between them
        drawn = exposed(dry_ground(place, ground_around(u).slope, widths, 1));
        return;
    }
    drawn = exposed(through_water(radiance_in_water(-1, place, width, widths, 1), a.d, t * a.metres));
}
