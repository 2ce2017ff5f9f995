// The share of a splat in a pixel, with what an edge of the lattice mirrors.

SplatShape shape_of(SplatRecord r) {
    return SplatShape(vec2(0), r.along, r.across, r.lean, r.transposed);
}

SplatEdge west_of(SplatRecord r) {
    return SplatEdge(vec2(r.west_x, r.west_y), vec2(r.west_normal_x, r.west_normal_y), r.west_inside);
}

SplatEdge south_of(SplatRecord r) {
    return SplatEdge(vec2(r.south_x, r.south_y), vec2(r.south_normal_x, r.south_normal_y), r.south_inside);
}

bool is_edge(SplatEdge e) {
    return e.normal != vec2(0);
}

// `corner` is the pixel's lower corner, from the splat's centre.
float splat_share(SplatRecord r, vec2 corner) {
    SplatShape s = shape_of(r);
    SplatEdge west = west_of(r);
    SplatEdge south = south_of(r);
    float sum = splat_in_pixel(s, corner);
    if (!is_edge(west) && !is_edge(south)) return sum;
    if (is_edge(west)) sum += splat_in_pixel(s, corner - west.mirrored);
    if (is_edge(south)) sum += splat_in_pixel(s, corner - south.mirrored);
    if (is_edge(west) && is_edge(south)) sum += splat_in_pixel(s, corner - west.mirrored - south.mirrored);
    vec2 middle = corner + 0.5;
    return sum * inside_edge(west, middle) * inside_edge(south, middle);
}
