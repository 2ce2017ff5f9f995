// Bilinear look-up of a cell-centred field along one axis, and what lies beyond each kind of side.
// A place is whole + part cells from the centre of cell 0, part in [0, 1).

#define SIDE_PERIODIC 0
#define SIDE_WALL 1
#define SIDE_ABSORBING 2

struct AxisPlace {
    int low;           // the two cells around the place, in [0, n)
    int high;
    real weight;       // of high; low has 1 - weight
    real wraps_low;    // periods between the place and where its cells are taken from
    real wraps_high;
    real mirror_low;   // -1 where a slope along this axis is seen in the mirror of a wall, else 1
    real mirror_high;
    real water;        // 0 where the water is still beyond an absorbing side, else 1
    real within;       // fraction of [place - half, place + half] that lies in the domain
};

KERNEL int wraps_of(int cell, int n) {
    int wraps = cell / n;
    return cell < wraps * n ? wraps - 1 : wraps;
}

KERNEL int nearest_cell(int cell, int n) {
    return cell < 0 ? 0 : (cell >= n ? n - 1 : cell);
}

KERNEL AxisPlace place_on_axis(int whole, real part, int n, int side, real half_width) {
    AxisPlace p;
    p.weight = part;
    real from_low_side = (real(whole) + real(0.5)) + part;
    real from_high_side = (real(n - whole) - real(0.5)) - part;
    p.within = clamp((min(from_low_side, half_width) + min(from_high_side, half_width)) / (real(2) * half_width),
                     real(0), real(1));
    p.water = real(1);
    p.mirror_low = real(1);
    p.mirror_high = real(1);
    p.wraps_low = real(0);
    p.wraps_high = real(0);
    if (side == SIDE_PERIODIC) {
        int wraps_low = wraps_of(whole, n);
        int wraps_high = wraps_of(whole + 1, n);
        p.wraps_low = real(wraps_low);
        p.wraps_high = real(wraps_high);
        p.low = whole - wraps_low * n;
        p.high = whole + 1 - wraps_high * n;
        return p;
    }
    p.low = nearest_cell(whole, n);
    p.high = nearest_cell(whole + 1, n);
    if (side == SIDE_WALL) {
        p.mirror_low = p.low == whole ? real(1) : real(-1);
        p.mirror_high = p.high == whole + 1 ? real(1) : real(-1);
    } else {
        p.water = from_low_side < real(0) || from_high_side < real(0) ? real(0) : real(1);
    }
    return p;
}

// Periods between the place and its cells, between the two as the field is.
KERNEL real wraps_between(AxisPlace p) {
    return p.wraps_low + p.weight * (p.wraps_high - p.wraps_low);
}

// The part of a sample that light reaches: beyond a wall none enters.
KERNEL real lit_part(AxisPlace p, int side) {
    return side == SIDE_WALL ? p.within : real(1);
}

// The part of a lit sample that the ledger counts: all of it where its base pixel is one of the map's `size` (if counted
// by that), else what lies in the domain.
KERNEL real counted_part(AxisPlace p, int side, bool by_base, int base, int size) {
    real on_map = base >= 0 && base < size ? real(1) : real(0);
    real inside = side == SIDE_ABSORBING ? p.within : real(1);
    return by_base ? on_map : inside;
}

// Value between four cells; the first word names the x side, the second the y side.
KERNEL real bilinear(real low_low, real high_low, real low_high, real high_high, real weight_x, real weight_y) {
    real low = low_low + weight_y * (low_high - low_low);
    real high = high_low + weight_y * (high_high - high_low);
    return low + weight_x * (high - low);
}
