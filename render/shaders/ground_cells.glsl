// Look-up of the ground: a margin of one cell as high as the cells beside it.

struct GroundHere {
    float height;
    vec2 slope;
};

vec2 cells_of(vec2 place) { return (wrapped(place) - vec2(s.x0, s.y0)) / vec2(s.cell_x, s.cell_y); }

// `u` in cells from the domain's corner.
GroundHere ground_around(vec2 u) {
    vec2 at = clamp(u + 0.5, vec2(0), vec2(s.ground_nx, s.ground_ny) + 0.999);
    vec2 low = floor(at), w = at - low;
    int stride = s.ground_nx + 2, k = int(low.y) * stride + int(low.x);
    float a = ground_value(k), b = ground_value(k + 1), c = ground_value(k + stride), d = ground_value(k + stride + 1);
    GroundHere here;
    here.height = bilinear(a, b, c, d, w.x, w.y);
    here.slope = vec2(mix(b - a, d - c, w.y) / s.cell_x, mix(c - a, d - b, w.x) / s.cell_y);
    return here;
}

float ground_at(vec2 place) { return ground_around(cells_of(place)).height; }
