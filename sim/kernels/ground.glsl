// Shapes of the ground. A relief is a height above the level on which a shape stands, 0 where the shape is not.

// A plane through a point: its level there, its slope vector, and where from the point one looks.
KERNEL real plane_level(real level, real2 slope, real2 from_point) {
    return level + dot(slope, from_point);
}

// A paraboloid of depth h0 at its centre whose rim, at level 0, has radius a (Thacker 1981); q = r^2 / a^2.
KERNEL real bowl_level(real h0, real q) {
    return h0 * (q - real(1));
}

// A truncated cone of unit height at distance r from its axis.
KERNEL real cone_relief(real r, real toe_radius, real crest_radius) {
    if (r <= crest_radius) return real(1);
    if (r >= toe_radius) return real(0);
    return (toe_radius - r) / (toe_radius - crest_radius);
}

// A parabolic hump of unit height, q = (x / half width)^2 + (y / half width)^2.
KERNEL real parabola_relief(real q) {
    return max(real(0), real(1) - q);
}

// A Gaussian one, which falls to 1/e at q = 1.
KERNEL real gaussian_relief(real q) {
    return exp(-q);
}

// Ground that rises beyond a line; d: distance beyond it.
KERNEL real beach_relief(real slope, real d) {
    return slope * max(real(0), d);
}

// Ground one unit higher beyond a line, the line included.
KERNEL real step_relief(real d) {
    return d >= real(0) ? real(1) : real(0);
}

// A box of unit height, its sides included; p: place from its centre along its sides.
KERNEL real block_relief(real2 p, real2 half_size) {
    return abs(p.x) <= half_size.x && abs(p.y) <= half_size.y ? real(1) : real(0);
}
