// A grid of beams that is twice as fine where light converges: the paper's future work, by one level.
#pragma once

#include "caustics/beam_image.hpp"

namespace waterlight {

/// Two grids over the same window, the second twice as fine each way. Each cell's light is in one of both: the flux of
/// the other's beams is 0. Light at a border between them may cross by what the finer edge bends, so that a picture is
/// a sum of both, and not for fields that must hold each depth's flux.
struct RefinedBeams {
    Beams coarse;
    Beams fine;
    int refined_cells = 0;  ///< of the coarse grid
};

/// Takes the finer beams where on the way to the floor the section of a coarse beam shrinks below `share` of that on
/// the surface, in (0, 1), or folds. Throws InputError where a setting is out of its range.
void make_refined_beams(const BeamSettings& settings, double share, const Surface& surface, RefinedBeams& beams);

/// draw_beams() of both.
void draw_beams(const BeamImageSettings& settings, const RefinedBeams& beams, BeamImage& image);

}  // namespace waterlight
