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
