// Several samples in each pixel of the floor map.
#pragma once

#include <memory>

#include "caustics/floor.hpp"

namespace waterlight {

/// The settings of a map with one sample a pixel whose pixels are the samples of this one.
FloorSettings one_sample_a_pixel(const FloorSettings& settings);

/// The mapper for `settings` from one for one_sample_a_pixel(settings): averages of its pixels.
std::unique_ptr<FloorMapper> average_samples(const FloorSettings& settings, std::unique_ptr<FloorMapper> of_samples);

}  // namespace waterlight
