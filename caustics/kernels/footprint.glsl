// The adaptive footprint of the floor map. Lengths in pixels.

// The adaptive footprint: the light of a sample covers evenly the parallelogram of the columns a = dX/di, b = dX/dj of
// the landing map, taken from its neighbours. Of the two, c is the one that climbs more and d the other. The
// parallelogram is cut along c into strips; each is slid along c until its two other sides lie along a row of pixels.
// Slid strips tile the floor as the parallelogram does, since a row of them has no gaps, and cover pixels by a closed
// form, row by row. What sliding costs falls with the square of the number of strips.
struct Parallelogram {
    real width;   // of all strips along a row, signed: d = (width + slant slide, height slide)
    real height;  // of c, > 0
    real slant;   // of c: columns from its foot to its head
    real slide;   // d's height in units of c's
};

KERNEL Parallelogram landed_parallelogram(real2 a, real2 b) {
    const real least = real(1e-4);  // pixels: what is less high is taken for this high
    bool a_climbs = abs(a.y) > abs(b.y);
    real2 c = a_climbs ? a : b;
    real2 d = a_climbs ? b : a;
    real up = c.y < real(0) ? real(-1) : real(1);
    Parallelogram f;
    f.height = max(least, abs(c.y));
    f.slant = up * c.x;
    f.slide = d.y / f.height;
    f.width = d.x - f.slant * f.slide;
    return f;
}

// Half of what it spans along x and y, all strips together.
KERNEL real2 half_extent(Parallelogram f, real strips) {
    real apart = real(1) - real(1) / strips;
    return real2(real(0.5) * (abs(f.width) / strips + abs(f.slant) + apart * abs(f.width + f.slant * f.slide)),
                 real(0.5) * f.height * (real(1) + apart * abs(f.slide)));
}

// Strip number `strip` of `strips`, counted from 0, of a footprint about `centre`.
struct Strip {
    real2 centre;
    real width;
    real height;
    real slant;
};

KERNEL Strip strip_of(Parallelogram f, real2 centre, real strip, real strips) {
    real along = (strip + real(0.5)) / strips - real(0.5);
    Strip s;
    s.centre = real2(centre.x + along * (f.width + f.slant * f.slide), centre.y + along * f.height * f.slide);
    s.width = abs(f.width) / strips;
    s.height = f.height;
    s.slant = f.slant;
    return s;
}

// What lies of a strip between two heights. Seen along y its light is a trapezoid about `centre`: a box of one width
// smeared over the other.
struct StripPart {
    real part;      // of the strip's light
    real centre;    // x
    real reach;     // half of what it spans along x
    real narrow;    // the lesser of the two widths
    real per_wide;  // 1 / (2 x the greater)
    real per_narrow;
};

KERNEL StripPart strip_between(Strip s, real low, real high) {
    const real thin = real(1e-6);  // pixels: a narrower strip is a line
    real per_height = real(1) / s.height;
    real foot = clamp((low - s.centre.y) * per_height, real(-0.5), real(0.5));
    real head = clamp((high - s.centre.y) * per_height, real(-0.5), real(0.5));
    StripPart p;
    p.part = head - foot;
    p.centre = s.centre.x + s.slant * real(0.5) * (head + foot);
    real smear = abs(s.slant) * p.part;
    real wide = max(max(s.width, smear), thin);
    p.narrow = max(min(s.width, smear), thin);
    p.reach = real(0.5) * (wide + p.narrow);
    p.per_wide = real(0.5) / wide;
    p.per_narrow = real(1) / p.narrow;
    return p;
}

// The fraction of the part's light that lies below x.
KERNEL real part_below(StripPart p, real x) {
    real from_centre = x - p.centre;
    real from_end = max(real(0), p.reach - abs(from_centre));
    real on_flank = min(from_end, p.narrow);
    real tail = on_flank * p.per_narrow * (real(2) * from_end - on_flank) * p.per_wide;
    return from_centre < real(0) ? tail : real(1) - tail;
}

// The fractions of a strip's light that lie in a row of pixels, [foot, foot + 1), below x = 1, 2, 3 and anywhere.
struct RowShare {
    real one;
    real two;
    real three;
    real all;
};

KERNEL RowShare row_of_strip(Strip s, real foot) {
    StripPart p = strip_between(s, foot, foot + real(1));
    RowShare share;
    share.one = p.part * part_below(p, real(1));
    share.two = p.part * part_below(p, real(2));
    share.three = p.part * part_below(p, real(3));
    share.all = p.part;
    return share;
}

// The same of a strip without slant: a box.
KERNEL RowShare row_of_box(Strip s, real foot) {
    const real thin = real(1e-6);
    real per_width = real(1) / max(s.width, thin);
    real per_height = real(1) / s.height;
    real left = s.centre.x * per_width - real(0.5);
    real low = s.centre.y * per_height - real(0.5);
    RowShare share;
    share.all = clamp((foot + real(1)) * per_height - low, real(0), real(1)) -
                clamp(foot * per_height - low, real(0), real(1));
    share.one = share.all * clamp(per_width - left, real(0), real(1));
    share.two = share.all * clamp(real(2) * per_width - left, real(0), real(1));
    share.three = share.all * clamp(real(3) * per_width - left, real(0), real(1));
    return share;
}

// The fraction of a strip's light in the rectangle between two corners.
KERNEL real light_within(Strip s, real2 low, real2 high) {
    StripPart p = strip_between(s, low.y, high.y);
    return max(real(0), p.part) * max(real(0), part_below(p, high.x) - part_below(p, low.x));
}

// What the window lets through to the map.
struct FloorReach {
    real2 half_window;  // pixels beside the base pixel
    real2 size;         // of the map, pixels
    real strips;
};

// How much of a sample's light the window sees and, of that, how much lies on the map.
struct SampleShare {
    real in_window;
    real on_map;
};

// The part of both that falls to one of its strips, whose centre is given from that of the base pixel.
KERNEL SampleShare share_of(FloorReach reach, Strip s, real2 base) {
    real2 window = real2(reach.half_window.x + real(0.5), reach.half_window.y + real(0.5));
    real2 low = real2(max(-window.x, real(-0.5) - base.x), max(-window.y, real(-0.5) - base.y));
    real2 high = real2(min(window.x, reach.size.x - real(0.5) - base.x),
                       min(window.y, reach.size.y - real(0.5) - base.y));
    SampleShare share;
    share.in_window = light_within(s, real2(-window.x, -window.y), window) / reach.strips;
    share.on_map = light_within(s, low, high) / reach.strips;
    return share;
}
