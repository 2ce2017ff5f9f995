// Look-up of the surface's fields: a level of them has a margin of one cell, in which the sides are already told.

struct CellsAround {
    int low;     // index of the cell of least x and y
    int stride;
    vec2 weight;
};

// `u` in cells of the finest level from the domain's corner.
CellsAround cells_around(vec2 u) {
    vec2 at = clamp(u / p.level_scale + 0.5, vec2(0), vec2(p.level_nx, p.level_ny) + 0.999);
    vec2 low = floor(at);
    CellsAround c;
    c.stride = p.level_nx + 2;
    c.low = p.level_offset + int(low.y) * c.stride + int(low.x);
    c.weight = at - low;
    return c;
}

float elevation_at(CellsAround c) {
    return bilinear(surface_cell(c.low).w, surface_cell(c.low + 1).w, surface_cell(c.low + c.stride).w,
                    surface_cell(c.low + c.stride + 1).w, c.weight.x, c.weight.y);
}

// Whether more water than `depth` stands over the ground at `u`: the shore as the fields have it, whatever the meshes.
bool is_wet(vec2 u, float depth) { return elevation_at(cells_around(u)) > ground_around(u).height + depth; }

struct Slopes {
    vec2 mean;
    float variance;  // per axis, of what is spread within the footprint
    vec2 per_x, per_y;  // change of the mean, 1/m
};

// `along` and `across` are the semi-axes of the footprint, m.
Slopes slopes_at(CellsAround c, vec2 along, vec2 across) {
    vec3 a = vec3(surface_cell(c.low)), b = vec3(surface_cell(c.low + 1));
    vec3 e = vec3(surface_cell(c.low + c.stride)), f = vec3(surface_cell(c.low + c.stride + 1));
    vec3 low = a + c.weight.x * (b - a), high = e + c.weight.x * (f - e);
    vec3 here = low + c.weight.y * (high - low);
    Slopes slopes;
    slopes.mean = vec2(here);
    // A slope that changes evenly over the footprint's width 2 w has the variance w^2 / 3 times its change squared.
    slopes.per_x = vec2((b - a) + c.weight.y * ((f - e) - (b - a))) / (s.cell_x * p.level_scale);
    slopes.per_y = vec2(high - low) / (s.cell_y * p.level_scale);
    vec2 change_along = slopes.per_x * along.x + slopes.per_y * along.y;
    vec2 change_across = slopes.per_x * across.x + slopes.per_y * across.y;
    float spread = (dot(change_along, change_along) + dot(change_across, change_across)) / 6;
    slopes.variance = min(spread, s.mean_variance) + (coarse ? here.z : 0);
    return slopes;
}
