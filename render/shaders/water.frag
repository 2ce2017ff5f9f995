// The water's surface: what it reflects and what is seen through it, from above or from below.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "render/shaders/includes.glsl"
#include "render/shaders/sky.glsl"
#include "render/shaders/light.glsl"
#include "render/shaders/water.glsl"
#include "render/shaders/surface_cells.glsl"
#include "render/shaders/sun_in_water.glsl"

layout(location = 0) out vec4 drawn;

struct Point {
    vec3 place;
    float distance;  // from the eye, m
    float width;     // of the pixel there, across the sight, m
    vec2 slope;
    float variance;
    PerPixel moved, slope_change;  // slopes in x and y
    PerPixel turn;                 // of the ray
};

vec3 slope_over(Slopes slopes, vec3 move) { return vec3(slopes.per_x * move.x + slopes.per_y * move.y, 0); }

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
    q.turn = turn_of_sight(a);
    q.moved = moved_along(unmoved, q.turn, a.d, q.distance, normal_of(q.slope));
    q.slope_change = PerPixel(slope_over(slopes, q.moved.right), slope_over(slopes, q.moved.up));
    return q;
}

PerPixel turned_normal(Point q, vec3 normal) {
    return PerPixel(turn_of_normal(normal, q.slope_change.right.xy), turn_of_normal(normal, q.slope_change.up.xy));
}

vec3 from_above(Point q, vec3 d) {
    vec3 normal = normal_of(visible_slope(-d, q.slope, q.variance, 1));
    PerPixel turned = turned_normal(q, normal);
    RayRefraction refracted = refract_ray(d, normal, s.index, s.fresnel);
    turned = PerPixel(turn_refracted(d, normal, s.index, q.turn.right, turned.right),
                      turn_refracted(d, normal, s.index, q.turn.up, turned.up));
    vec3 below = seen_in_water(q.place, refracted.direction, q.width, q.moved, turned);
    if (overlay == OVERLAY_FLOOR || overlay == OVERLAY_ERROR) return below;
    vec3 sky = sky_above(reflect_ray(d, normal));
    return refracted.transmittance / (s.index * s.index) * below + (1 - refracted.transmittance) * sky +
           glint(d, q.slope, q.variance);
}

vec3 from_below(Point q, vec3 d) {
    vec3 upwards = normal_of(visible_slope(-d, q.slope, q.variance, -1)), normal = -upwards;
    PerPixel turned = turned_normal(q, upwards);
    RayRefraction refracted = refract_ray(d, normal, 1 / s.index, s.fresnel);
    vec3 mirrored = reflect_ray(d, normal);
    mirrored.z = min(mirrored.z, -0.003);
    turned = PerPixel(turn_reflected(d, upwards, q.turn.right, turned.right),
                      turn_reflected(d, upwards, q.turn.up, turned.up));
    vec3 below = seen_in_water(q.place, mirrored, q.width, q.moved, turned);
    vec3 sky = sky_above(refracted.direction);
    return s.index * s.index * (refracted.transmittance * sky + shine(d, q.slope, q.variance)) +
           (1 - refracted.transmittance) * below;
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
