// Linear waves of one speed c: eta_tt = c^2 laplacian(eta), on cells of dx by dy, by leapfrog in the elevation eta at
// whole steps and its rate v = eta_t at half steps:
//   v(n+1/2) = v(n-1/2) + dt c^2 L eta(n),   eta(n+1) = eta(n) + dt v(n+1/2).

// Speed of waves that are long against the depth h.
KERNEL real long_wave_speed(real g, real h) {
    return sqrt(g * h);
}

// What a step adds to the rate: the 5-point Laplacian of the elevation, its x part times wx and its y part times wy,
// where wx = c^2 dt / dx^2 and wy = c^2 dt / dy^2. Differences to the centre are zero where the water is level.
KERNEL real leapfrog_kick(real centre, real west, real east, real south, real north, real wx, real wy) {
    real twice = real(2) * centre;
    return wx * ((west + east) - twice) + wy * ((south + north) - twice);
}

// The elevation a step later.
KERNEL real leapfrog_drift(real elevation, real rate, real dt) {
    return elevation + dt * rate;
}

// The Courant number c dt sqrt(1/dx^2 + 1/dy^2); the scheme is stable up to 1.
KERNEL real leapfrog_courant(real c, real dt, real dx, real dy) {
    return c * dt * sqrt(real(1) / (dx * dx) + real(1) / (dy * dy));
}

// Square of the wave number as the 3-point second difference sees it: (2 sin(k dx / 2) / dx)^2.
KERNEL real discrete_wave_number2(real k, real dx) {
    real s = real(2) * sin(real(0.5) * k * dx) / dx;
    return s * s;
}

// The discrete dispersion relation: sin^2(w dt / 2) for squared discrete wave numbers kx2, ky2.
KERNEL real leapfrog_sin2(real c, real dt, real kx2, real ky2) {
    return real(0.25) * (c * dt) * (c * dt) * (kx2 + ky2);
}

// Squared amplitude of a mode with squared discrete wave number k2 and frequency w. From its elevation a cos(w t) and its
// rate at the same time, -a sin(w t) sin(w dt) / dt, follows a^2 = elevation^2 + (rate dt / sin(w dt))^2, with
// sin^2(w dt) / dt^2 = c^2 k2 (1 - sin^2(w dt / 2)). The level itself, k2 = 0, has no rate, and a mode at the very limit
// of stability, w dt = pi, has none that tells.
KERNEL real leapfrog_amplitude2(real elevation, real rate, real c, real dt, real k2) {
    real left = real(1) - leapfrog_sin2(c, dt, k2, real(0));
    real kinetic = k2 > real(0) && left > real(1e-9) ? rate * rate / (c * c * k2 * left) : real(0);
    return elevation * elevation + kinetic;
}

// Central difference over two cells of size d.
KERNEL real central_slope(real before, real after, real d) {
    return (after - before) * (real(0.5) / d);
}

// Damping rate of a sponge (1/s) at the fraction x of its width, 0 at the domain and 1 at its far end.
KERNEL real sponge_rate(real x, real peak_rate) {
    return peak_rate * x * x * x;
}

// The kick in a sponge, v_t = c^2 L eta - 2 rate v: half the decay, the kick, half the decay; decay = exp(-rate dt).
KERNEL real sponge_kick(real rate_of_rise, real kick, real decay) {
    return decay * (decay * rate_of_rise + kick);
}
