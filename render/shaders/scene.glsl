// What every pass of a picture sees: the scene's buffers, the variant, the ray of a pixel. After the kernels.

layout(constant_id = 0) const bool in_water = false;      // the camera
layout(constant_id = 1) const bool wall_x = false;        // sides
layout(constant_id = 2) const bool wall_y = false;
layout(constant_id = 3) const bool wraps_x = false;
layout(constant_id = 4) const bool wraps_y = false;
layout(constant_id = 5) const bool uneven = false;        // ground
layout(constant_id = 6) const int map_colours = 0;        // of the floor map; 0: there is none
layout(constant_id = 7) const bool wall_maps = false;
layout(constant_id = 8) const int scatter = SCATTER_NONE; // what is known of light scattered in the water
layout(constant_id = 9) const int floor_pattern = 0;
layout(constant_id = 10) const int wall_pattern = 0;
layout(constant_id = 11) const int deck_pattern = 0;
layout(constant_id = 12) const int overlay = OVERLAY_NONE;
layout(constant_id = 13) const bool uniform_sky = false;
layout(constant_id = 14) const bool coarse = false;       // a level of the surface's fields above the first
layout(constant_id = 15) const bool outside = false;      // a camera in the water, but beside the pool

layout(constant_id = 16) const int kind = 0;              // what of several things is drawn

layout(push_constant) uniform Push { PassParameters p; };
layout(std140, binding = 0) uniform SceneBlock { SceneParameters s; };
layout(std430, binding = 1) readonly buffer SurfaceLevels { vec4 surface_cells[]; };  // slopes, variance, elevation
layout(std430, binding = 2) readonly buffer LightMaps { float light[]; };
layout(std430, binding = 3) readonly buffer Medium { float medium[]; };  // phase function, then the volume
layout(std430, binding = 4) readonly buffer Ground { float ground[]; };  // heights, with a margin of one cell
layout(std430, binding = 5) readonly buffer Copies { vec4 copies[]; };   // shift of each copy
layout(std430, binding = 6) readonly buffer Palette { vec4 palette[]; };

const float pi = 3.14159265358979;
const float far_away = 1e6;

struct Sight {
    vec3 r;        // towards the pixel, 1 along the view
    vec3 d;        // the same of length 1
    float metres;  // |r|
};

vec3 eye() { return vec3(p.eye_x, p.eye_y, p.eye_z); }

Sight sight(vec2 fragment) {
    Sight a;
    a.r = vec3(p.corner_x, p.corner_y, p.corner_z) + (fragment.x - 0.5) * vec3(p.right_x, p.right_y, p.right_z) +
          (fragment.y - 0.5) * vec3(p.up_x, p.up_y, p.up_z);
    a.metres = length(a.r);
    a.d = a.r / a.metres;
    return a;
}

// How far along the view a fragment of a mesh is, of its 1 / w. At an edge the middle of the pixel may be beyond the
// triangle, and behind the horizon.
float way_of_fragment(float per_way) { return per_way > 1e-6 ? max(p.near, 1 / per_way) : 1e6; }

// Width of a pixel, in metres per metre of distance along the view.
float pixel_width() { return length(vec3(p.right_x, p.right_y, p.right_z)); }

// What the next pixel to the right, and the next up, differ by. Derivatives of the device would not do: at the edge of a
// triangle the pixels beyond it need not read buffers.
struct PerPixel {
    vec3 right, up;
};

PerPixel turn_of_sight(Sight a) {
    vec3 right = vec3(p.right_x, p.right_y, p.right_z), up = vec3(p.up_x, p.up_y, p.up_z);
    return PerPixel((right - dot(right, a.d) * a.d) / a.metres, (up - dot(up, a.d) * a.d) / a.metres);
}

// Of the place that is met `way` metres on, on a plane, where the ray starts from places that are moved and is turned.
PerPixel moved_along(PerPixel from, PerPixel turn, vec3 d, float way, vec3 normal) {
    return PerPixel(moved_onto(from.right + way * turn.right, d, normal),
                    moved_onto(from.up + way * turn.up, d, normal));
}

const PerPixel unmoved = PerPixel(vec3(0), vec3(0));

// Where a place of the world is in the picture. Depths fall from 1 at `near` to 0 far away.
vec4 seen(vec3 place) {
    vec3 d = place - eye();
    return vec4(p.scale_x * dot(d, vec3(p.right_x, p.right_y, p.right_z)),
                p.scale_y * dot(d, vec3(p.up_x, p.up_y, p.up_z)), p.near,
                dot(d, vec3(p.forward_x, p.forward_y, p.forward_z)));
}

// Radiance as the target holds it: in units of the exposure, within what half floats hold.
vec4 exposed(vec3 radiance) { return vec4(min(radiance * s.per_exposure, vec3(6e4)), 1); }

vec3 to_sun() { return vec3(s.sun_x, s.sun_y, s.sun_z); }

// Into the domain, by whole periods.
vec2 wrapped(vec2 place) {
    vec2 size = vec2(s.x1 - s.x0, s.y1 - s.y0);
    vec2 periods = floor((place - vec2(s.x0, s.y0)) / size);
    if (wraps_x) place.x -= periods.x * size.x;
    if (wraps_y) place.y -= periods.y * size.y;
    return place;
}

vec3 overlay_colour(float value) {
    return palette[int(clamp((value - s.overlay_low) * s.overlay_scale, 0, 255))].rgb / s.per_exposure;
}
