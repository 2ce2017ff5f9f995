// A phase function as a picture evaluates it for many rays at once.
#pragma once

#include <span>
#include <vector>

#include "caustics/kernels/phase.hpp"
#include "caustics/kernels/phase_table.hpp"
#include "caustics/light.hpp"

namespace waterlight {

/// A phase function's value as a fraction, so that the loop may divide once by all that it divides by.
struct PhaseFraction {
    float numerator, denominator;
};

/// In closed form, for it takes a root and no power.
struct HenyeyGreenstein {
    float g;
    PhaseFraction operator()(float cosine) const { return {1, f32::henyey_greenstein_inverse(g, cosine)}; }
};

/// Read from a table in the logarithm of sin^2(angle / 2), linear between 32 nodes an octave over 24 octaves: within
/// 1e-4 of a smooth function. Below the smallest node, at an angle of 5e-4, it stays at that node's value.
class PhaseTable {
  public:
    explicit PhaseTable(const Phase& phase);
    PhaseFraction operator()(float cosine) const {
        const f32::PhaseNode node = f32::phase_node(cosine);
        return {values_[node.index] + node.part * (values_[node.index + 1] - values_[node.index]), 1};
    }
    std::span<const float> values() const { return table_; }

  private:
    std::vector<float> table_;
    const float* values_;
};

}  // namespace waterlight
