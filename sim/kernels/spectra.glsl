// Shapes of wave spectra. u: frequency over peak frequency.

// Pierson & Moskowitz (1964) in peak frequencies; its integral over u is 1: 5 u^-5 exp(-5/4 u^-4).
KERNEL real pierson_moskowitz_shape(real u) {
    real u4 = u * u * u * u;
    return real(5) / (u4 * u) * exp(real(-1.25) / u4);
}

// What JONSWAP (Hasselmann et al. 1973) multiplies it with: gamma^exp(-(u - 1)^2 / 2 s^2), s = 0.07 below, 0.09 above.
KERNEL real jonswap_peak(real u, real gamma) {
    real s = u <= real(1) ? real(0.07) : real(0.09);
    real x = (u - real(1)) / s;
    return exp(log(gamma) * exp(real(-0.5) * x * x));
}

// Kitaigorodskii's depth factor, which TMA multiplies it with (Bouws et al. 1985, eq. 5):
// tanh^2(kh) / (1 + 2kh / sinh 2kh).
KERNEL real tma_depth_factor(real kh) {
    real x = min(kh, real(20));
    real t = tanh(x);
    // 1 / sinh(2x) = (1 - t^2) / 2t
    return t * t / (real(1) + x * (real(1) - t * t) / t);
}

// The saturated range of a wind sea (Phillips 1958; constant of Pierson & Moskowitz 1964), m2/Hz.
KERNEL real phillips_saturation(real f, real g) {
    real two_pi = real(6.283185307179586);
    real f2 = f * f;
    return real(0.0081) * g * g / (two_pi * two_pi * two_pi * two_pi * f2 * f2 * f);
}
