// Materials: how much of their albedo a place reflects, as the mean over a footprint of the given width, so that a pattern
// finer than a pixel is its mean.

#define FINISH_PLAIN 0
#define FINISH_TILES 1
#define FINISH_SAND 2

const real joint_half = real(0.012);   // half the width of a joint between tiles, of a tile's side
const real joint_factor = real(0.5);   // what it reflects of what a tile does
const real tile_spread = real(0.06);   // most that tiles differ from their mean

// Integral from 0 to x of what is 1 within joint_half of whole numbers.
KERNEL real joints_to(real x) {
    real whole = floor(x + real(0.5));
    return real(2) * joint_half * whole + clamp(x - whole, -joint_half, joint_half);
}

KERNEL real joint_part(real x, real width) {
    real w = max(width, real(1e-4));
    return clamp((joints_to(x + real(0.5) * w) - joints_to(x - real(0.5) * w)) / w, real(0), real(1));
}

// A number in [-1, 1] for each pair of whole numbers.
KERNEL real speckle(real i, real j) {
    real x = sin(i * real(12.9898) + j * real(78.233)) * real(43758.5453);
    return real(2) * (x - floor(x)) - real(1);
}

// Coordinates and width in tiles.
KERNEL real tiles(real2 at, real2 width) {
    real tile = (real(1) - joint_part(at.x, width.x)) * (real(1) - joint_part(at.y, width.y));
    real sharp = clamp(real(1) - real(2) * max(width.x, width.y), real(0), real(1));
    real own = real(1) + sharp * tile_spread * speckle(floor(at.x), floor(at.y));
    return tile * own + (real(1) - tile) * joint_factor;
}

// Its mean over many tiles.
KERNEL real tiles_mean() {
    real tile = (real(1) - real(2) * joint_half) * (real(1) - real(2) * joint_half);
    return tile + (real(1) - tile) * joint_factor;
}

// Ripples of wavelength 1 that wander, with grain on them; mean 1. What is below twice the footprint fades.
KERNEL real sand(real2 at, real2 width) {
    real w = max(width.x, width.y);
    real keep = clamp(real(1.5) - real(2) * w, real(0), real(1));
    real wander = real(0.35) * sin(real(1.1) * at.x + real(0.6) * sin(real(0.7) * at.y)) +
                  real(0.20) * sin(real(2.3) * at.x - real(0.9) * at.y);
    real ripple = sin(real(6.283185307179586) * (at.y + wander));
    real grains = real(24);
    real keep_grain = clamp(real(1.5) - real(2) * w * grains, real(0), real(1));
    real grain = speckle(floor(at.x * grains), floor(at.y * grains));
    return real(1) + real(0.10) * keep * ripple + real(0.08) * keep_grain * grain;
}

// `at` and `width` in metres, of a pattern of size `side`.
KERNEL real finish(int pattern, real2 at, real2 width, real side) {
    real scale = real(1) / side;
    if (pattern == FINISH_TILES) return tiles(at * scale, width * scale);
    if (pattern == FINISH_SAND) return sand(at * scale, width * scale);
    return real(1);
}

KERNEL real finish_mean(int pattern) {
    return pattern == FINISH_TILES ? tiles_mean() : real(1);
}
