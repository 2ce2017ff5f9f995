// The benchmarks of beams, the same for every back-end.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "caustics/beam_renderer.hpp"

namespace waterlight::bench {

using MakeRenderer = std::function<std::unique_ptr<BeamRenderer>()>;

/// Registers beams_image/BACKEND/... and beams_volume/BACKEND/...
void register_beams(const std::string& backend, const MakeRenderer& make);

/// Registers beams_make/cpu/... and beams_image_reduced/cpu/...
void register_beam_parts();

}  // namespace waterlight::bench
