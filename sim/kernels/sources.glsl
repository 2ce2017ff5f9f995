// Shapes of the sources. But for a push none has a volume: the integral of each profile over the plane (or the line) is
// zero.

// A drop at distance r from its centre, q = r^2 / R^2, of unit height: (1 - q) exp(-q).
KERNEL real drop_profile(real q) {
    return (real(1) - q) * exp(-q);
}

// Where a drop is: what little volume sampling leaves in it is taken out in proportion to this.
KERNEL real drop_footprint(real q) {
    return exp(-q);
}

// Two-dimensional Fourier transform of drop_profile, divided by pi R^2; q = k^2 R^2 / 4.
KERNEL real drop_transform(real q) {
    return q * exp(-q);
}

// Water pushed up at distance r from the middle, q = r^2 / R^2, of unit height: exp(-q). Its volume is pi R^2.
KERNEL real push_profile(real q) {
    return exp(-q);
}

// Two-dimensional Fourier transform of push_profile, divided by pi R^2; q = k^2 R^2 / 4.
KERNEL real push_transform(real q) {
    return exp(-q);
}

// Cross-section of a wavemaker at distance x from its line, q = x^2 / w^2, unit height: minus the second derivative of a
// Gaussian. Its Fourier transform is w sqrt(2 pi) (k w)^2 exp(-(k w)^2 / 2), largest at k w = sqrt(2).
KERNEL real wavemaker_profile(real q) {
    return (real(1) - q) * exp(real(-0.5) * q);
}

// That transform divided by w; q = (k w)^2.
KERNEL real wavemaker_transform(real q) {
    return sqrt(real(6.283185307179586)) * q * exp(real(-0.5) * q);
}

// Where a wavemaker is across its line: serves as drop_footprint does.
KERNEL real wavemaker_footprint(real q) {
    return exp(real(-0.5) * q);
}

// Strength along a wavemaker that runs from s = 0 to s = length: 1 inside, 0 outside, smooth over its width w.
KERNEL real wavemaker_along(real s, real length, real w) {
    return real(0.5) * (tanh(s / w) - tanh((s - length) / w));
}
