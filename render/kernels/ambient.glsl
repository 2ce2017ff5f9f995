// Diffuse light in a layer of water over a diffuse floor: closed form of an infinite slab whose light is isotropic in each
// hemisphere. r_ext is the reflectance of flat water for a uniform sky, 1 - r_int = (1 - r_ext) / n^2 what leaves through
// it of isotropic light from below. `passage` is what absorption leaves on the way through the layer.

// Light on the floor but for the sun's own: the sky's, and what the surface throws back of all that the floor reflects.
// down = passage (1 - r_ext) sky + passage^2 r_int albedo (sun + down).
KERNEL real ambient_on_floor(real sky, real sun, real albedo, real r_ext, real r_int, real passage) {
    real back = passage * passage * r_int * albedo;
    return (passage * (real(1) - r_ext) * sky + back * sun) / (real(1) - back);
}

// Light of an upward ray just above the water, as irradiance: the sky's reflected and what leaves the water.
KERNEL real ambient_from_water(real sky, real up, real r_ext, real r_int) {
    return r_ext * sky + (real(1) - r_int) * up;
}

// What absorption leaves of diffuse light through `depth`: 1.2 metres of path per metre, as of a uniform sky's light below
// flat water (1.13) to isotropic light in thin layers (2).
KERNEL real diffuse_passage(real absorption, real depth) {
    return exp(real(-1.2) * absorption * depth);
}

// Light that water scatters once towards an eye on a way of `length`, per scattering coefficient, phase function and
// irradiance across the beam where the way starts (DESIGN.md section 6): extinction c on the way, `rise` the extinction of
// the sun's light per metre of way (c times metres of sunlight's path per metre of way; negative upwards).
KERNEL real scattered_once(real c, real rise, real way) {
    real k = c + rise;
    real kl = k * way;
    return abs(kl) < real(1e-3) ? way * (real(1) - real(0.5) * kl) : (real(1) - exp(-min(max(kl, real(-60)), real(80)))) / k;
}
