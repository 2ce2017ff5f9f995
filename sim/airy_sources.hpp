// Drops, rain and wavemakers in the variables of the airy model's modes, exact in time within a step.
//
// A disturbance D of a mode's elevation at time t adds D cos(w (t - start)) to the state's a and D sin(w (t - start))
// to its b: so much of the free oscillation that it starts. A forcing does so at every moment. The constant mode takes
// none.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/airy_modes.hpp"
#include "sim/disturbance.hpp"

namespace waterlight {

/// Each drop by its analytic transform; walls mirror it and periodic sides repeat it, by the modes themselves.
void add_drops(const AiryModes& modes, std::span<const Drop> drops, AiryState& state);

/// The same of what disturbs the water at time_s, which stands for the drops' own.
void add_disturbances(const AiryModes& modes, std::span<const Disturbance> disturbances, double time_s,
                      AiryState& state);

/// A wavemaker's modes and their forced motion.
class ForcedModes {
  public:
    /// `transform` serves once, to find the slots of inflow_shape(); slots below 1e-6 of the largest are left out.
    ForcedModes(const Wavemaker& maker, const Grid& grid, const AiryModes& modes, PlaneTransform& transform);

    /// What the maker does from from_s to to_s, in closed form: its signal (inflow_signal) is a sum of cosines, before
    /// and after the end of its ramp, and the integral of a cosine times exp(i w t) is a sinc, well-conditioned at
    /// resonance too.
    void add(double from_s, double to_s, AiryState& state) const;

  private:
    struct Mode {
        std::size_t slot;
        double inflow_m_s;
        double omega;
    };
    /// amplitude cos(omega (t - start) + phase)
    struct Tone {
        double amplitude, omega, phase;
    };
    void add_tones(std::span<const Tone> tones, double from_s, double to_s, AiryState& state) const;

    std::vector<Mode> modes_;
    std::vector<Tone> ramp_, steady_;
    double start_s_, full_s_;
};

}  // namespace waterlight
