// The sun is a disc: where light of its rim lands beside that of its centre. Include after optics.glsl.

// Semi-axes of the ellipse that light of a disc fills below water at rest, in metres per metre of depth and radian of the
// disc's half-angle: along the sun's azimuth and across. Light that comes at the angle i from the vertical travels
// tan(t), sin(t) = sin(i) / n: d tan(t) / di = cos(i) / (n cos^3(t)), and tan(t) / sin(i) = 1 / (n cos(t)).
KERNEL real2 disc_axes(real sin_elevation, real n) {
    real cos_t = sqrt(real(1) - (real(1) - sin_elevation * sin_elevation) / (n * n));
    return real2(sin_elevation / (n * cos_t * cos_t * cos_t), real(1) / (n * cos_t));
}
