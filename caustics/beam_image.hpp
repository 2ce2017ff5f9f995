// A picture of the light that beams scatter towards a camera.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "caustics/beams.hpp"
#include "caustics/camera.hpp"
#include "caustics/picture_ground.hpp"

namespace waterlight {

struct BeamImageSettings {
    Camera camera;         ///< below the surface; it may stand beside a pool whose sides are walls, without its glass
    WaterOptics optics;    ///< as that of the beams
    int samples = 1;       ///< sections of a ray's way through a beam, each sampled in its middle, >= 1
    int reduction = 1;     ///< draws one ray of so many each way and enlarges; 1 draws all
    double range_m = 100;  ///< how far the camera sees; to there periodic sides repeat the beams, > 0
    std::optional<PictureGround> ground;  ///< none: a flat floor
    /// Hide what is behind them, and are dark: rays end there. Placed by the beams' time, repeated as the beams are.
    std::shared_ptr<const ObjectSet> objects;
};

/// What a picture took.
struct BeamImageCounts {
    std::int64_t beams = 0;           ///< that the picture shows, copies beyond periodic sides included
    std::int64_t covered_pixels = 0;  ///< that see any beam
    std::int64_t sections = 0;        ///< rays through the outlines of cells of two beams; 0 on vulkan: not counted
};

struct BeamImage {
    Field<float> radiance;  ///< W/(m2 sr), single-scattered; row 0 at the bottom
    BeamImageCounts counts;
};

/// Adds up for every pixel what each beam scatters on the ray's way through it: one sample in the middle, extinction on
/// both legs. Each beam is met once by each ray inside the outline of its corners, so that no edge is seen twice.
/// `image` is reused where its size fits. Throws InputError where a setting is out of its range.
void draw_beams(const BeamImageSettings& settings, const Beams& beams, BeamImage& image);

}  // namespace waterlight
