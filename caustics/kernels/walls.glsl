// Light on its way through a pool between walls.

// Part of the way from `start` to `end` along one axis after which light leaves [low, high], in [0, 1]; 1 where it does not.
KERNEL real part_inside(real start, real end, real low, real high) {
    real to = end < low ? low : high;
    real part = (to - start) / (end - start);
    return end >= low && end <= high ? real(1) : clamp(part, real(0), real(1));
}
