// What a ray gathers on its way through the two beams of a cell.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "sim/kernels/real.glsl"

#include "caustics/kernels/beams.glsl"
#include "caustics/kernels/beams_along.glsl"
#include "caustics/kernels/phase.glsl"
#include "caustics/kernels/phase_table.glsl"
#include "caustics/shaders/beam_image_parameters.glsl"

layout(constant_id = 0) const bool tabulated = false;  // the phase function, else Henyey & Greenstein's
layout(constant_id = 1) const bool uneven = false;     // beams end on ground of their own
layout(constant_id = 2) const bool ends_early = false; // rays meet ground before the floor

layout(push_constant) uniform Push { BeamPixelParameters p; };
layout(std430, binding = 1) readonly buffer PhaseValues { float phase_values[]; };
layout(std430, binding = 2) readonly buffer Reach { float reach[]; };  // t at which each pixel's ray meets the ground

layout(location = 0) flat in vec4 edge[4];
layout(location = 4) flat in vec4 mean;
layout(location = 5) flat in vec4 power;
layout(location = 6) flat in vec4 top[2];
layout(location = 8) flat in vec4 ground[2];

layout(location = 0) out float radiance;

struct Ray {
    vec3 r;
    float metres;      // |r|
    float per_length;  // one over it
    float entry;
    vec2 phase;        // the phase function's value as a fraction
};

WaterSpan beam_span(int beam, vec3 r, WaterSpan span) {
    span = within_lid(span, dot(top[beam].xyz, r), top[beam].w);
    if (uneven) span = within_lid(span, dot(ground[beam].xyz, r), ground[beam].w);
    return span;
}

vec2 phase_fraction(Ray ray) {
    float cosine = towards_eye(mean.xy, mean.z, ray.r) * ray.per_length;
    if (!tabulated) return vec2(1, henyey_greenstein_inverse(p.mean_cosine, cosine));
    PhaseNode node = phase_node(cosine);
    float value = phase_values[node.index];
    return vec2(value + node.part * (phase_values[node.index + 1] - value), 1);
}

// The chords of the ray from span.near to span.far, cut where they reach beyond the water, as one.
BeamChord meet(Ray ray, WaterSpan span, bool cut_all) {
    vec3 r = ray.r;
    vec2 v = speed_past(mean.xy, r);
    CellCorners c = cell_corners(edge_numbers(edge[0].xy, edge[0].zw, v), edge_numbers(edge[1].xy, edge[1].zw, v),
                                 edge_numbers(edge[2].xy, edge[2].zw, v), edge_numbers(edge[3].xy, edge[3].zw, v), v,
                                 r.z, span.near, span.far);
    BeamChord first = beam_chord(c.c0, c.c1, c.c2, ray.phase.y);
    BeamChord second = beam_chord(c.c0, c.c2, c.c3, ray.phase.y);
    float over = max(chord_excess(first, span.near, span.far, r.z, power.z),
                     chord_excess(second, span.near, span.far, r.z, power.z));
    if (uneven)
        over = max(over, max(chord_excess_below(first, r.z, power.w), chord_excess_below(second, r.z, power.w)));
    first.density *= power.x * ray.phase.x;
    second.density *= power.y * ray.phase.x;
    if (cut_all || over > 0) {
        first = cut_chord(first, beam_span(0, r, span));
        second = cut_chord(second, beam_span(1, r, span));
    }
    return joined_chord(first, second);
}

float light(Ray ray, BeamChord chord) {
    return light_from_chord(chord, p.extinction, mean.z, mean.w, ray.r.z, ray.entry, ray.metres);
}

CellSides sides_at(vec2 v, float down, float t) {
    return cell_sides(beside_ray(edge[0].xy, edge[0].zw, v, down, t), beside_ray(edge[1].xy, edge[1].zw, v, down, t),
                      beside_ray(edge[2].xy, edge[2].zw, v, down, t), beside_ray(edge[3].xy, edge[3].zw, v, down, t));
}

// What the speeds of the edges span.
CellSides bends(vec2 v, float down) {
    return cell_sides(edge_speed(edge[0].zw, v, down), edge_speed(edge[1].zw, v, down),
                      edge_speed(edge[2].zw, v, down), edge_speed(edge[3].zw, v, down));
}

// What reaches the eye of a ray that runs along the beams.
float follow(Ray ray, vec2 v, WaterSpan span) {
    WaterSpan first = beam_span(0, ray.r, span), second = beam_span(1, ray.r, span);
    int parts = parts_along(p.samples);
    float step = (span.far - span.near) / parts, square = step * step, sum = 0;
    CellSides bend = bends(v, ray.r.z);
    CellSides a = sides_at(v, ray.r.z, span.near);
    for (int k = 0; k < parts && step > 0; ++k) {
        float begin = span.near + k * step;
        CellSides b = sides_at(v, ray.r.z, begin + step);
        vec3 diagonal = vec3(a.s20, b.s20, square * bend.s20);
        float light = power.x * density_in_part(first, begin, step, vec3(a.s01, b.s01, square * bend.s01),
                                                vec3(a.s12, b.s12, square * bend.s12), diagonal) +
                      power.y * density_in_part(second, begin, step, -diagonal,
                                                vec3(a.s23, b.s23, square * bend.s23),
                                                vec3(a.s30, b.s30, square * bend.s30));
        sum += light * beam_attenuation(p.extinction, mean.z, mean.w, ray.r.z, ray.entry, ray.metres,
                                        begin + 0.5 * step);
        a = b;
    }
    return sum * ray.metres * ray.phase.x / ray.phase.y;
}

void main() {
    vec2 pixel = floor(gl_FragCoord.xy);
    Ray ray;
    ray.r = vec3(p.corner_x, p.corner_y, p.corner_z) + pixel.x * vec3(p.right_x, p.right_y, p.right_z) +
            pixel.y * vec3(p.up_x, p.up_y, p.up_z);
    ray.metres = length(ray.r);
    ray.per_length = 1 / ray.metres;
    ray.phase = phase_fraction(ray);
    WaterSpan span = water_span(ray.r, vec3(p.low_x, p.low_y, p.low_z), vec3(p.high_x, p.high_y, p.high_z));
    ray.entry = span.near;
    span.far = min(span.far, p.range * ray.per_length);
    if (ends_early) span.far = min(span.far, reach[int(pixel.y) * p.width + int(pixel.x)]);

    vec2 v = speed_past(mean.xy, ray.r);
    if (runs_along(v, ray.metres, ray.r.z, largest_off2(edge[0].zw, edge[1].zw, edge[2].zw, edge[3].zw))) {
        radiance = follow(ray, v, span);
        return;
    }
    BeamChord whole = meet(ray, span, false);
    if (p.samples == 1) {
        radiance = light(ray, whole);
        return;
    }
    radiance = 0;
    for (int k = 0; k < p.samples; ++k) radiance += light(ray, meet(ray, chord_part(whole, span, k, p.samples), true));
}
