// The positions texture of caustics mapping: of what receives light, its height in each texel of the light's image. The
// rest of its position is the texel's ray.
#pragma once

#include <optional>

#include "caustics/beam_ground.hpp"
#include "caustics/splat/splat_frame.hpp"

namespace waterlight {

/// Bilinear between the centres of texels. Beyond its edges it repeats on periodic sides; beyond others nothing is
/// seen.
class Receivers {
  public:
    /// Level at the image's own level, everywhere.
    explicit Receivers(const f64::LightImage& image) : level_(image.level) {}
    /// The ground as the light sees it through air and water alike, not bent, as far as the ground of the domain
    /// reaches. Throws InputError where it is not of the surface's cells or not finite.
    Receivers(const SplatFrame& frame, const Surface& surface, const Field<float>& bed_m);

    bool level() const { return heights_.empty(); }
    /// The height seen at a place in the image; the nearest that is seen where `sees` is false.
    double height_m(glm::dvec2 place_m) const;
    bool sees(glm::dvec2 place_m) const;
    /// True area over horizontal area of the ground at a place in the domain.
    double steepness(glm::dvec2 at_m) const;

    const Field<float>& heights_m() const { return heights_; }
    const Grid& texels() const { return texels_; }
    Boundary boundary() const { return boundary_; }

  private:
    double level_ = 0;
    std::optional<BeamGround> ground_;
    Field<float> heights_;  ///< of texels; empty: level
    Grid texels_;
    Boundary boundary_;
};

/// Where light lands.
struct Landed {
    double distance_m = 0;
    double last_step_m = 0;  ///< of the iteration
    bool seen = true;        ///< whether the light's image shows a receiver there
};

/// By iteration in the light's image. `direction` is a unit vector that goes down.
Landed land(const SplatOptions& options, const f64::LightImage& image, const Receivers& receivers, glm::dvec3 start_m,
            glm::dvec3 direction);

}  // namespace waterlight
