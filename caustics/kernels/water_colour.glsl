// How water treats light by its wavelength. Wavelengths in nm in vacuum, temperature in degrees C, salinity in permille.

// Refractive index of fresh and sea water relative to air (Quan & Fry, "Empirical equation for the index of refraction of
// seawater", Applied Optics 34, 1995, eq. 3): 400 to 700 nm, 0 to 30 degrees, 0 to 35 permille, to some 2e-5.
KERNEL real water_index(real nm, real temperature, real salinity) {
    real t2 = temperature * temperature;
    real salt = (real(1.779e-4) - real(1.05e-6) * temperature + real(1.6e-8) * t2) * salinity;
    real first = (real(15.868) + real(0.01155) * salinity - real(0.00423) * temperature) / nm;
    return real(1.31405) + salt - real(2.02e-6) * t2 + first - real(4382) / (nm * nm) +
           real(1.1455e6) / (nm * nm * nm);
}

// Scattering coefficient of water without particles, 1/m (Morel, "Optical properties of pure water and pure sea water",
// in Jerlov & Steemann Nielsen, "Optical aspects of oceanography", 1974; Mobley, "Light and Water", 1994, section 3.8):
// 0.00222 in fresh water and 0.00288 in sea water at 500 nm, the salt's part in proportion to salinity.
KERNEL real pure_water_scattering(real nm, real salinity) {
    return real(0.00222) * (real(1) + real(0.3 / 37) * salinity) * pow(real(500) / nm, real(4.32));
}

// Planck's law but for a factor: power per wavelength that a black body of this temperature (K) sends out.
KERNEL real black_body(real nm, real kelvin) {
    real x = real(1.438777e7) / (nm * kelvin);
    real relative = real(500) / nm;
    return relative * relative * relative * relative * relative / (exp(x) - real(1));
}
