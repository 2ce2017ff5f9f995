// The exact area of a polygon in a cell of a grid, by the signed area under its edges, as font rasterisers find it.

// Mean of clamp(u, 0, 1) where u goes evenly from a to b.
KERNEL real mean_clamped(real a, real b) {
    real low = min(a, b);
    real high = max(a, b);
    real rise = high - low;
    real inner_low = clamp(low, real(0), real(1));
    real inner_high = clamp(high, real(0), real(1));
    real within = real(0.5) * (inner_low + inner_high) * (inner_high - inner_low);
    real beyond = max(real(0), high - max(low, real(1)));
    return rise > real(1e-6) ? (within + beyond) / rise : clamp(real(0.5) * (a + b), real(0), real(1));
}

// The area of the cell [0, 1] x [0, 1] between edge ab and the cell's right side, positive where the edge goes up. Added
// up around a polygon that is counter-clockwise: minus the area of the polygon in the cell.
KERNEL real area_right_of(real2 a, real2 b) {
    real low = clamp(min(a.y, b.y), real(0), real(1));
    real high = clamp(max(a.y, b.y), real(0), real(1));
    real lean = (b.x - a.x) / (a.y == b.y ? real(1) : b.y - a.y);
    real right = real(1) - mean_clamped(a.x + lean * (low - a.y), a.x + lean * (high - a.y));
    return (b.y > a.y ? high - low : low - high) * right;
}

// Areas of a polygon left of x = 1, below y = 1, and in the corner where both hold.
struct CornerAreas {
    real left;
    real bottom;
    real corner;
};

// What edge ab adds to them, positive around a polygon that is counter-clockwise: integrals of min(x, 1) dy,
// -min(y, 1) dx and min(x, 1) d min(y, 1), between the places where x or y passes 1. No place of it is below 0.
KERNEL CornerAreas areas_under(real2 a, real2 b) {
    real2 way = real2(b.x - a.x, b.y - a.y);
    real none = real(1e-20);
    real at_x = clamp((real(1) - a.x) / (way.x == real(0) ? none : way.x), real(0), real(1));
    real at_y = clamp((real(1) - a.y) / (way.y == real(0) ? none : way.y), real(0), real(1));
    real first = min(at_x, at_y);
    real second = max(at_x, at_y);
    // Twice the means of min(x, 1) and min(y, 1) on the three parts, and how far each goes.
    real x0 = min(a.x, real(1));
    real x1 = min(a.x + first * way.x, real(1));
    real x2 = min(a.x + second * way.x, real(1));
    real x3 = min(b.x, real(1));
    real y0 = min(a.y, real(1));
    real y1 = min(a.y + first * way.y, real(1));
    real y2 = min(a.y + second * way.y, real(1));
    real y3 = min(b.y, real(1));
    real between = second - first;
    real last = real(1) - second;
    CornerAreas areas;
    areas.left = real(0.5) * way.y * ((x0 + x1) * first + (x1 + x2) * between + (x2 + x3) * last);
    areas.bottom = real(-0.5) * way.x * ((y0 + y1) * first + (y1 + y2) * between + (y2 + y3) * last);
    areas.corner = real(0.5) * ((x0 + x1) * (y1 - y0) + (x1 + x2) * (y2 - y1) + (x2 + x3) * (y3 - y2));
    return areas;
}

// Of a quadrangle, corners in order; times `each`.
KERNEL CornerAreas corner_areas(real2 a, real2 b, real2 c, real2 d, real each) {
    CornerAreas ab = areas_under(a, b);
    CornerAreas bc = areas_under(b, c);
    CornerAreas cd = areas_under(c, d);
    CornerAreas da = areas_under(d, a);
    CornerAreas sum;
    sum.left = each * ((ab.left + bc.left) + (cd.left + da.left));
    sum.bottom = each * ((ab.bottom + bc.bottom) + (cd.bottom + da.bottom));
    sum.corner = each * ((ab.corner + bc.corner) + (cd.corner + da.corner));
    return sum;
}

// The parts of a quadrangle, corners in order, in the four cells of [0, 2] x [0, 2], which holds it; `area` is its
// signed area. None is negative, and they add up to 1.
struct FourParts {
    real low_left;
    real low_right;
    real high_left;
    real high_right;
};

KERNEL FourParts parts_in_four(real2 a, real2 b, real2 c, real2 d, real area) {
    CornerAreas parts_of = corner_areas(a, b, c, d, real(1) / area);
    real left = clamp(parts_of.left, real(0), real(1));
    real bottom = clamp(parts_of.bottom, real(0), real(1));
    real corner = clamp(parts_of.corner, max(real(0), left + bottom - real(1)), min(left, bottom));
    FourParts parts;
    parts.low_left = corner;
    parts.low_right = bottom - corner;
    parts.high_left = left - corner;
    parts.high_right = real(1) - left - bottom + corner;
    return parts;
}
