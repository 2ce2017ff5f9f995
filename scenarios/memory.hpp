// Whether a run fits the machine, before anything is allocated.
#pragma once

#include <cstdint>

#include "scenarios/scenario.hpp"

namespace waterlight {

/// Bytes that a run takes at its peak, by count of cells and pixels.
struct MemoryEstimate {
    double cells = 0;    ///< for the wave model, its surface and the frames that wait to be written
    double pixels = 0;   ///< for the map and the frames that wait
    double volume = 0;   ///< for the fields in the water and the frames that wait
    double beams = 0;    ///< for the grids of beams and what each thread makes of them for fields
    double picture = 0;  ///< for the camera's picture, the strips it is drawn in, and the frames that wait
    double scene = 0;    ///< for the picture of the scene, on a device that shares the memory, and those that wait
    double walls = 0;    ///< for their maps and the frames that wait
    double light = 0;    ///< for the water and the vertices as methods that look from the light have them
    double total() const { return cells + pixels + volume + beams + picture + scene + walls + light; }
};

/// Cells (times 2 for each pair of absorbing sides that has a hidden margin) x bytes a cell of the model, plus pixels x
/// bytes a pixel of the method, plus the same of light in the water and on walls. An upper estimate, of the CPU, whose
/// threads count; of a picture, without the copies of beams that it shows beyond periodic sides.
MemoryEstimate estimate_memory(const Scenario& scenario);

/// What this machine can give, in bytes: available memory, or the limit of the control group or of the
/// process (ulimit -v) where that is less.
double machine_memory();

/// Throws InputError where the estimate exceeds `available` bytes.
void check_memory(const Scenario& scenario, double available);

}  // namespace waterlight
