// One ray of the truth, in double precision.
#pragma once

#include <algorithm>

#include "caustics/kernels/optics.hpp"
#include "caustics/truth.hpp"

namespace waterlight {

/// Where the light of one surface point lands and what is left of it.
struct TruthRay {
    glm::dvec3 start_m{0, 0, 0};
    glm::dvec2 floor_m{0, 0};
    double incident = 0;       ///< cos_i / N_z
    double transmittance = 0;  ///< Fresnel
    double remaining = 0;      ///< exp(-c L)
};

/// Lands rays of one sun through one water.
class TruthCaster {
  public:
    TruthCaster(const FloorSettings& settings, const TruthSurface& surface)
        : surface_(surface),
          depth_(settings.depth_m),
          index_(settings.optics.refractive_index),
          fresnel_(settings.optics.fresnel ? 1 : 0),
          extinction_(settings.optics.extinction_per_m()) {
        const bool lit = settings.sun.elevation_deg > 0;
        direction_ = lit ? settings.sun.direction() : glm::dvec3{0, 0, -1};
        irradiance_ = lit ? settings.sun.irradiance_w_m2 : 0;
        rest_ = f64::refract_sun(direction_, {0, 0}, index_, fresnel_).travel;
    }

    TruthRay cast(glm::dvec2 at_m) const {
        const SurfacePoint p = surface_.at(at_m);
        const f64::Refraction r = f64::refract_sun(direction_, p.slope, index_, fresnel_);
        const double descent = std::max(0.0, p.elevation_m + depth_);
        return {{at_m, p.elevation_m},
                at_m + descent * r.travel,
                r.incident,
                r.transmittance,
                f64::beer_lambert(extinction_, descent * r.path)};
    }

    const TruthSurface& surface() const { return surface_; }
    glm::dvec3 direction() const { return direction_; }
    double irradiance() const { return irradiance_; }
    /// Horizontal way of light through water at rest, m.
    glm::dvec2 rest_shift() const { return depth_ * rest_; }

  private:
    const TruthSurface& surface_;
    double depth_, index_, fresnel_, extinction_;
    double irradiance_ = 0;
    glm::dvec3 direction_{0, 0, -1};
    glm::dvec2 rest_{0, 0};
};

/// The rectangle of surface [low, high] whose light can reach the floor rectangle [floor_low, floor_high], cut at
/// walls. `reach_m` is how far light strays from where still water would send it.
struct SurfacePatch {
    glm::dvec2 low{0, 0};
    glm::dvec2 high{0, 0};
    bool empty() const { return !(high.x > low.x && high.y > low.y); }
};
SurfacePatch patch_above(const TruthCaster& caster, glm::dvec2 floor_low, glm::dvec2 floor_high, glm::dvec2 reach_m);

/// How far light strays at most, from a mesh of about spacing_m over the domain, with a tenth and two spacings to
/// spare.
glm::dvec2 largest_stray(const TruthCaster& caster, double spacing_m);

}  // namespace waterlight
