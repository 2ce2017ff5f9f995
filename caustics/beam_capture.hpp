// The surface as the sun sees it.
#pragma once

#include "caustics/beams.hpp"

namespace waterlight {

/// A point of the surface, and its slope.
struct CapturedPoint {
    glm::dvec3 at_m{0, 0, 0};
    glm::dvec2 slope{0, 0};
};

/// Meets the sun's rays with a surface, which must outlive it.
class SurfaceCapture {
  public:
    /// `reach_m` is how far beyond the domain rays will be asked for.
    SurfaceCapture(const Surface& surface, glm::dvec3 sun_direction, double reach_m);

    /// The first point of the surface on the ray through (at_m, 0). At a wall, rays beyond are drawn in to it.
    CapturedPoint capture(glm::dvec2 at_m) const;
    /// Of the surface, with what tilt adds beyond the domain.
    double lowest_m() const { return low_; }
    double highest_m() const { return high_; }
    /// Horizontal metres of a ray for each metre up.
    glm::dvec2 slant() const { return slant_; }

  private:
    glm::dvec2 hold(glm::dvec2 at_m) const;
    double meet(glm::dvec2 at_m) const;

    const Surface& surface_;
    glm::dvec2 slant_;
    double low_ = 0, high_ = 0;
    int steps_ = 1;  ///< of the march from high_ to low_
};

}  // namespace waterlight
