// From radiance to what a screen shows.

// Filmic tone curve: Narkowicz's fit of the ACES reference rendering and output transforms ("ACES filmic tone mapping
// curve", 2015), of a radiance relative to the exposure; and its inverse for values below 1.
KERNEL real filmic(real x) {
    return clamp(x * (real(2.51) * x + real(0.03)) / (x * (real(2.43) * x + real(0.59)) + real(0.14)), real(0),
                 real(1));
}

KERNEL real filmic_inverse(real y) {
    real a = real(2.51) - real(2.43) * y;
    real b = real(0.03) - real(0.59) * y;
    return (sqrt(b * b + real(0.56) * a * y) - b) / (real(2) * a);
}

// IEC 61966-2-1.
KERNEL real srgb_encoded(real linear) {
    return linear <= real(0.0031308) ? real(12.92) * linear
                                     : real(1.055) * pow(linear, real(1) / real(2.4)) - real(0.055);
}

KERNEL real srgb_decoded(real encoded) {
    return encoded <= real(0.04045) ? encoded / real(12.92)
                                    : pow((encoded + real(0.055)) / real(1.055), real(2.4));
}
