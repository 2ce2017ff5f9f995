// Trochoidal waves (Gerstner 1802; Fournier & Reeves 1986, "A simple model of ocean waves", eq. 1 to 3). A particle that
// rests at A is found at
//   x = A - sum of a k/|k| sin(theta),   z = sum of a cos(theta),   theta = k.A - w t + phase.

// Sums over the waves at one particle.
struct Gerstner {
    real shift_x;    // A - x
    real shift_y;
    real elevation;  // z
    real rise_x;     // dz/dA
    real rise_y;
    real xx;         // dx/dA, a symmetric matrix
    real xy;
    real yy;
};

KERNEL Gerstner gerstner_none() {
    Gerstner none = {real(0), real(0), real(0), real(0), real(0), real(1), real(0), real(1)};
    return none;
}

// With one more wave of vector k, direction d = k / |k| and amplitude a.
KERNEL Gerstner gerstner_add(Gerstner sum, real2 k, real2 d, real a, real sin_theta, real cos_theta) {
    real a_sin = a * sin_theta;
    real a_cos = a * cos_theta;
    sum.shift_x += d.x * a_sin;
    sum.shift_y += d.y * a_sin;
    sum.elevation += a_cos;
    sum.rise_x -= k.x * a_sin;
    sum.rise_y -= k.y * a_sin;
    sum.xx -= d.x * k.x * a_cos;
    sum.xy -= d.x * k.y * a_cos;
    sum.yy -= d.y * k.y * a_cos;
    return sum;
}

// (dx/dA)^-1 v: the slope of the surface for v = dz/dA, Newton's step for v = a distance missed.
KERNEL real2 gerstner_solve(Gerstner sum, real2 v) {
    real per_det = real(1) / (sum.xx * sum.yy - sum.xy * sum.xy);
    return real2((sum.yy * v.x - sum.xy * v.y) * per_det, (sum.xx * v.y - sum.xy * v.x) * per_det);
}

// How far the mean level of one wave lies below that of its particles: half of k a^2.
KERNEL real gerstner_sinking(real k, real a) {
    return real(0.5) * k * a * a;
}
