// Phase functions: the part of scattered light that goes into each direction, per steradian; over the sphere they add up
// to 1. `cosine` is that of the angle between the light before and after.

// Henyey & Greenstein (1941); g is the mean cosine, in (-1, 1). One over their function, and it.
KERNEL real henyey_greenstein_inverse(real g, real cosine) {
    real x = max(real(1) + g * g - real(2) * g * cosine, real(1e-12));
    return x * sqrt(x) * (real(12.566370614359172) / (real(1) - g * g));
}

KERNEL real henyey_greenstein(real g, real cosine) {
    return real(1) / henyey_greenstein_inverse(g, cosine);
}

// Pure water: density fluctuations after Einstein and Smoluchowski, in Morel's form (Mobley 1994, eq. 3.30).
KERNEL real pure_water(real cosine) {
    return real(0.06225) * (real(1) + real(0.835) * cosine * cosine);
}

// Fournier & Forand (1994) as given by Mobley, Sundman & Boss, "Phase function effects on oceanic light fields" (2002),
// eq. 11 to 13: particles of index n relative to the water whose number falls with size as r^-slope, 3 < slope < 5.
// Without bound as sine2 = sin^2(angle / 2) goes to 0, but integrable.
KERNEL real fournier_forand(real n, real slope, real sine2) {
    real v = real(0.5) * (real(3) - slope);
    real d180 = real(4) / (real(3) * (n - real(1)) * (n - real(1)));
    real d = d180 * sine2;
    d = abs(d - real(1)) < real(1e-4) ? real(1.0001) : d;  // where numerator and denominator vanish together
    real dv = pow(d, v);
    real dv180 = pow(d180, v);
    real one_d = real(1) - d;
    real one_dv = real(1) - dv;
    real cosine = real(1) - real(2) * sine2;
    real forward = (v * one_d - one_dv + (d * one_dv - v * one_d) / sine2) / (one_d * one_d * dv);
    real backward = (real(1) - dv180) / ((d180 - real(1)) * dv180) * (real(3) * cosine * cosine - real(1));
    return real(0.079577471545947668) * (forward + real(0.25) * backward);
}
