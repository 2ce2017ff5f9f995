// A floor map of several wavelengths as a picture takes it.
#pragma once

#include <array>
#include <span>

#include "caustics/spectral_floor.hpp"

namespace waterlight {

/// Irradiance of red, green and blue light, each as if all of the sun's were of that colour: white light on a white
/// floor is then white. A wavelength counts for the colour of 650, 550 and 450 nm that is nearest; a colour that has
/// none takes the wavelength nearest to its own. `bands` are not empty. `colours` are reused where their sizes fit.
void fill_colours(std::span<const BandMap> bands, std::array<Field<float>, 3>& colours);

}  // namespace waterlight
