// A phase function as a picture evaluates it for many rays at once.
#pragma once

#include <vector>

#include "caustics/kernels/phase.hpp"
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
        const float sine2 = f32::clamp(0.5F - 0.5F * cosine, least, 1.0F);
        const std::int32_t bits = std::bit_cast<std::int32_t>(sine2) - first_bits;
        const std::int32_t node = bits >> (23 - node_bits);
        const float part = static_cast<float>(bits & ((1 << (23 - node_bits)) - 1)) / (1 << (23 - node_bits));
        return {values_[node] + part * (values_[node + 1] - values_[node]), 1};
    }

  private:
    static constexpr int node_bits = 5, octaves = 24;
    static constexpr float least = 1.0F / (1 << octaves);
    static constexpr std::int32_t first_bits = std::bit_cast<std::int32_t>(least);

    std::vector<float> table_;
    const float* values_;
};

}  // namespace waterlight
