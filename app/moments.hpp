// When a run stops to look at the water.
#pragma once

#include <vector>

#include "scenarios/scenario.hpp"

namespace waterlight {

/// A time at which a run stops: a frame, or a reading of the probes alone.
struct Moment {
    double time_s = 0;
    bool is_frame = true;
};

/// In order, from the frame at the start; frames every_s apart, the last at duration_s, and where checks look.
std::vector<Moment> moments_of(const Scenario& scenario);

/// The numbers, from 0, of the frames that are every_s apart: in a movie those between, for checks, and one at the end
/// of a broken interval would stumble.
std::vector<int> regular_frames(const std::vector<Moment>& moments, double every_s);

}  // namespace waterlight
