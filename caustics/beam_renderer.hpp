// Pictures and fields of light in the water, by a back-end that keeps what it needs between frames.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "caustics/beam_image.hpp"
#include "caustics/beam_refine.hpp"
#include "caustics/beam_volume.hpp"

namespace waterlight {

/// What a back-end did, and for how long.
struct StageTime {
    std::string stage;
    double seconds = 0;
};

class BeamRenderer {
  public:
    virtual ~BeamRenderer() = default;
    /// "cpu" or "vulkan".
    virtual std::string_view backend() const = 0;
    /// draw_beams() of caustics/beam_image.hpp; both back-ends give the same picture within 1 % relative RMSE.
    virtual void draw(const BeamImageSettings& settings, const Beams& beams, BeamImage& image) = 0;
    /// fill_volume() of caustics/beam_volume.hpp; both give the same fields within 1e-4 relative RMSE.
    virtual void fill(const Beams& beams, glm::ivec3 cells, BeamVolume& volume) = 0;
    /// Of the last picture or fields, as the device kept them; empty where none does.
    virtual std::vector<StageTime> stage_times() const { return {}; }
};

std::unique_ptr<BeamRenderer> make_beam_renderer_cpu();

/// draw() of both grids.
void draw_beams(BeamRenderer& renderer, const BeamImageSettings& settings, const RefinedBeams& beams, BeamImage& image);

}  // namespace waterlight
