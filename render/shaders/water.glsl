// The way of sight through the water, to what it meets there.

vec3 sight_extinction() { return vec3(s.sight_r, s.sight_g, s.sight_b); }

struct Meeting {
    float way;  // metres to it
    int wall;   // 0 to 3; -1: the floor or ground
};

// The first ground on the way from `from` along d within `end` metres: steps, then bisection.
float ground_way(vec3 from, vec3 d, float end) {
    const int steps = 12, halvings = 6;
    float begin = d.z < 0 ? max(0, (s.ground_high - from.z) / d.z) : 0;
    end = min(end, d.z < 0 ? (s.ground_low - from.z) / d.z : far_away);
    float low = begin, high = end, step = (end - begin) / steps;
    bool met = false;
    for (int k = 1; k <= steps && !met; ++k) {
        float t = begin + k * step;
        met = from.z + t * d.z <= ground_at(vec2(from) + t * vec2(d));
        low = met ? low : t;
        high = t;
    }
    for (int k = 0; k < halvings; ++k) {
        float t = 0.5 * (low + high);
        bool below = from.z + t * d.z <= ground_at(vec2(from) + t * vec2(d));
        high = below ? t : high;
        low = below ? low : t;
    }
    return met ? 0.5 * (low + high) : end;
}

Meeting meet(vec3 from, vec3 d) {
    Meeting m;
    m.wall = -1;
    m.way = d.z < -1e-5 ? max(0, (-s.depth - from.z) / d.z) : far_away;
    if (wall_x) {
        float speed = abs(d.x) > 1e-6 ? d.x : 1e-6;
        float t = ((speed > 0 ? s.x1 : s.x0) - from.x) / speed;
        if (t < m.way) m.wall = speed > 0 ? 1 : 0;
        m.way = min(m.way, t);
    }
    if (wall_y) {
        float speed = abs(d.y) > 1e-6 ? d.y : 1e-6;
        float t = ((speed > 0 ? s.y1 : s.y0) - from.y) / speed;
        if (t < m.way) m.wall = speed > 0 ? 3 : 2;
        m.way = min(m.way, t);
    }
    m.way = max(m.way, 0);
    if (uneven) {
        float t = ground_way(from, d, m.way);
        if (t < m.way) m.wall = -1;
        m.way = min(t, m.way);
    }
    return m;
}

float phase_at(float cosine) {
    PhaseNode node = phase_node(cosine);
    return medium_value(node.index) + node.part * (medium_value(node.index + 1) - medium_value(node.index));
}

float volume_at(vec3 place) {
    vec2 home = wrapped(vec2(place));
    vec2 at = (home - vec2(s.x0, s.y0)) / vec2(s.x1 - s.x0, s.y1 - s.y0) * vec2(s.volume_nx, s.volume_ny) - 0.5;
    vec2 low = floor(at), w = at - low;
    ivec2 most = ivec2(s.volume_nx, s.volume_ny) - 1;
    ivec2 i0 = ivec2(low), i1 = i0 + 1;
    i0 = wraps_x || wraps_y ? ivec2(mod(vec2(i0), vec2(most + 1))) : i0;
    i1 = wraps_x || wraps_y ? ivec2(mod(vec2(i1), vec2(most + 1))) : i1;
    i0 = clamp(i0, ivec2(0), most);
    i1 = clamp(i1, ivec2(0), most);
    int k = clamp(int((place.z / s.volume_depth + 1) * s.volume_nz), 0, s.volume_nz - 1);
    int slice = s.volume_offset + k * s.volume_nx * s.volume_ny;
    int row0 = slice + i0.y * s.volume_nx, row1 = slice + i1.y * s.volume_nx;
    return bilinear(medium_value(row0 + i0.x), medium_value(row0 + i1.x), medium_value(row1 + i0.x),
                    medium_value(row1 + i1.x), w.x, w.y);
}

// Light of the sun that the water scatters once towards the eye on the way from `from` along d.
vec3 scattered(vec3 from, vec3 d, float way) {
    if (scatter == SCATTER_NONE) return vec3(0);
    vec3 sunlight = vec3(s.travel_x, s.travel_y, -1) / s.path;
    float strength = s.scattering * phase_at(-dot(sunlight, d));
    vec3 c = sight_extinction();
    float depth = max(0, -from.z);
    if (scatter == SCATTER_FLAT) {
        vec3 here = s.entering * s.path * exp(-(s.extinction + colours()) * s.path * depth);
        vec3 rise = -(s.extinction + colours()) * s.path * d.z;
        return strength * here *
               vec3(scattered_once(c.x, rise.x, way), scattered_once(c.y, rise.y, way), scattered_once(c.z, rise.z, way));
    }
    const int parts = 5;
    float step = way / parts;
    vec3 sum = vec3(0);
    for (int k = 0; k < parts; ++k) {
        float t = (k + 0.5) * step;
        vec3 at = from + t * d;
        sum += volume_at(at) * exp(-c * t - colours() * s.path * max(0, -at.z));
    }
    return strength * step * sum;
}

// Radiance that arrives at `from` along the way d, from what is met there and from the water between.
// `moved` and `turned` are those of `from` and d.
vec3 seen_in_water(vec3 from, vec3 d, float width, PerPixel moved, PerPixel turned) {
    Meeting m = meet(from, d);
    vec3 place = from + m.way * d;
    width += m.way * pixel_width() * (1 / s.index);
    vec3 plane = m.wall < 0 ? vec3(0, 0, 1) : wall_inward(m.wall);
    vec2 widths = widths_on_pattern(m.wall, moved_along(moved, turned, d, m.way, plane));
    vec3 seen = radiance_in_water(m.wall, place, width, widths, 1);
    if (overlay == OVERLAY_FLOOR || overlay == OVERLAY_ERROR) return seen;
    return seen * exp(-sight_extinction() * m.way) + scattered(from, d, m.way);
}

// Metres of sight in the air beside a pool, before it enters the water.
float entry_way(vec3 d) {
    float t = 0;
    if (!outside) return t;
    if (wall_x) t = max(t, ((d.x > 0 ? s.x0 : s.x1) - p.eye_x) / (abs(d.x) > 1e-6 ? d.x : 1e-6));
    if (wall_y) t = max(t, ((d.y > 0 ? s.y0 : s.y1) - p.eye_y) / (abs(d.y) > 1e-6 ? d.y : 1e-6));
    return t;
}

// What is left at the eye of radiance from `way` metres off, for a camera in the water; what the water adds comes too.
vec3 through_water(vec3 radiance, vec3 d, float way) {
    if (!in_water) return radiance;
    float entry = min(entry_way(d), way);
    vec3 from = eye() + entry * d;
    return radiance * exp(-sight_extinction() * (way - entry)) + scattered(from, d, way - entry);
}
