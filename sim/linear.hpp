// The wave equation with one speed, by leapfrog.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "sim/sines.hpp"
#include "sim/sources.hpp"
#include "sim/water.hpp"
#include "sim/wave_model.hpp"

namespace waterlight {

struct LinearSettings {
    Grid grid;
    Boundary boundary;
    Water water;             ///< speed c = sqrt(g h)
    double cfl = 0.9;        ///< c dt sqrt(1/dx^2 + 1/dy^2), in (0, 1]
    double sponge_m = 0;     ///< width of the hidden margin beyond each absorbing side; 0 chooses it
    std::vector<Sine> sines;              ///< initial state; they travel at speed c
    std::vector<StandingWave> standing;   ///< initial state
    std::vector<Source> sources;
};

/// Real is float (production) or double (reference). Throws InputError where a setting is out of its range.
template <class Real>
std::unique_ptr<WaveModel> make_linear(const LinearSettings& settings);

extern template std::unique_ptr<WaveModel> make_linear<float>(const LinearSettings&);
extern template std::unique_ptr<WaveModel> make_linear<double>(const LinearSettings&);

}  // namespace waterlight
