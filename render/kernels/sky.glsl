// The sky. Directions are unit vectors from which light comes, or to the sun. Needs acos.

// Relative luminance of the CIE's standard clear sky of low turbidity (CIE S 011/E:2003 = ISO 15469:2004, type 12):
// gradation 1 + a exp(b / cos Z), a = -1, b = -0.32; indicatrix 1 + c (exp(d x) - exp(d pi/2)) + e cos^2 x of the
// angle x from the sun, c = 10, d = -3, e = 0.45.
KERNEL real clear_sky(real cos_zenith, real cos_sun) {
    real gradation = real(1) - exp(real(-0.32) / max(cos_zenith, real(0.01)));
    real angle = acos(clamp(cos_sun, real(-1), real(1)));
    real indicatrix = real(1) + real(10) * (exp(real(-3) * angle) - real(0.008983291021129429)) +
                      real(0.45) * cos_sun * cos_sun;
    return gradation * indicatrix;
}

// Its colour: blue above, paler towards the horizon. Mean of red, green and blue 1.
KERNEL real3 sky_tint(real cos_zenith) {
    real pale = real(1) - clamp(cos_zenith, real(0), real(1));
    pale = pale * pale * pale;
    return real3(real(0.42) + real(0.40) * pale, real(0.90) + real(0.12) * pale, real(1.68) - real(0.52) * pale);
}
