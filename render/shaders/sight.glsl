// The ray of a pixel, and places of the scene. After the scene's buffers.

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
    return vec3(palette[int(clamp((value - s.overlay_low) * s.overlay_scale, 0, 255))]) / s.per_exposure;
}
