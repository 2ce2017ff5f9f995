// A Gaussian that smooths a map: less noise for a bias that can be told.
#pragma once

#include "sim/field.hpp"

namespace waterlight {

struct BlurSettings {
    double sigma_pixels = 1;  ///< standard deviation, in [0, 4096]; 0 changes nothing
    bool round_x = false;     ///< the map's other side comes next; else it is mirrored at its sides
    bool round_y = false;     ///< so what is spread stays on the map, and an even map stays as it is
};

Field<double> blurred(const Field<double>& map, const BlurSettings& settings);

/// What smoothing has added to each pixel, to second order: half the kernel's variance times the Laplacian, taken of
/// the smoothed map, which noise does not make useless. It holds where the map changes slowly over sigma; at a
/// caustic's edge it does not, but tells that the bias is large.
Field<double> blur_bias(const Field<double>& smoothed, const BlurSettings& settings);

/// By what it multiplies noise that is independent from pixel to pixel: 1 / (2 sqrt(pi) sigma) for wide ones.
double blur_noise(double sigma_pixels);

}  // namespace waterlight
