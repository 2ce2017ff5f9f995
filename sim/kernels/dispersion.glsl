// Dispersion relations. k: wave number (rad/m), h: depth (m), g: gravity (m/s2), s: surface tension / density (m3/s2).

// Square of the angular frequency of gravity-capillary waves (Airy): (g k + s k^3) tanh(k h).
KERNEL real airy_omega2(real k, real h, real g, real s) {
    return (g + s * k * k) * k * tanh(k * h);
}

// Its derivative along k, which is 2 w times the group velocity.
KERNEL real airy_omega2_slope(real k, real h, real g, real s) {
    real kh = min(k * h, real(40));
    real t = tanh(kh);
    return (g + real(3) * s * k * k) * t + (g + s * k * k) * kh * (real(1) - t * t);
}
