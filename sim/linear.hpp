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
    Water water;                         ///< speed c = sqrt(g h); the depth must be finite
    double cfl = 0.9;                    ///< c dt sqrt(1/dx^2 + 1/dy^2), in (0, 1]
    double sponge_m = 0;                 ///< width of the hidden margin beyond each absorbing side; 0 chooses it
    std::vector<Sine> sines;             ///< initial state; they travel, frozen ones start at rest
    std::vector<StandingWave> standing;  ///< initial state, at rest
    std::vector<Source> sources;
};

/// The leapfrog scheme on square cells:
///   eta(n+1) - 2 eta(n) + eta(n-1) = (c dt)^2 L eta(n),  L the 5-point Laplacian,
/// kept as eta and its rate half a step before (sim/kernels/linear.glsl). The first frame sets dt for good: the longest
/// step allowed by cfl of which the frame is a multiple or a whole part. Frames of that length end on a step; one of
/// any other length ends between two, and its surface is that of a step of part length from the last whole one, which
/// is not kept. So the scheme is stable and of second order whatever the frames. Waves obey
///   sin^2(w dt/2) = (c dt)^2 [sin^2(kx dx/2)/dx^2 + sin^2(ky dy/2)/dy^2]
/// and sines start with the rate of that w, so that one that fits the domain is a pure mode and travels at the scheme's
/// own phase speed w/k, below c by the fraction (k dx)^2/24 at most.
///
/// A drop falls at the first step at or after its time. Slopes are central differences: mirrored at walls, wrapped at
/// periodic sides; beyond absorbing sides the water of the margin is used. energy_j counts the margin too.
template <class Real>
class LinearModel : public WaveModel {
  public:
    /// The elevation (m) of a cell of the domain, in the model's own precision.
    virtual Real elevation_m(int i, int j) const = 0;
    /// The length (s) of the steps; before the first advance() the longest that cfl allows.
    virtual double step_s() const = 0;
};

/// Real is float (production) or double (reference). Throws InputError where a setting is out of its range.
template <class Real>
std::unique_ptr<LinearModel<Real>> make_linear(const LinearSettings& settings);

extern template std::unique_ptr<LinearModel<float>> make_linear<float>(const LinearSettings&);
extern template std::unique_ptr<LinearModel<double>> make_linear<double>(const LinearSettings&);

}  // namespace waterlight
