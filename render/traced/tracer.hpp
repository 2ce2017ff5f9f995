// Follows ways of sight. One for each thread.
#pragma once

#include <optional>

#include "caustics/objects/water_scene.hpp"
#include "render/traced/scene_text.hpp"
#include "render/traced/traced_picture.hpp"

namespace waterlight {

/// A way of sight: a cone about a ray (Amanatides, "Ray tracing with cones", 1984).
struct Sight {
    Traveller traveller{};
    double width_m = 0;      ///< of the cone where the ray starts
    double spread = 0;       ///< that it grows by per metre
    double share = 1;        ///< of the picture's light that it carries
    int met = 0;             ///< surfaces so far
    bool off_water = false;  ///< comes from the water's surface, where the sun's reflection is counted
    unsigned seed = 0;       ///< of the sample

    double width_at(double way) const { return width_m + way * spread; }
};

class Tracer {
  public:
    Tracer(const TracedScene& scene, const WaterScene& water, const SceneData& data, const TraceOptions& options);

    /// Radiance that comes along the ray of a pixel's place, (0, 0) the middle of the first, `part` of its width wide.
    glm::dvec3 seen_at(glm::dvec2 pixel, double part, unsigned seed);

  private:
    struct AirMeeting;
    struct WaterPoint;

    glm::dvec3 radiance(const Sight& sight);
    glm::dvec3 in_glass(const Sight& sight);
    glm::dvec3 in_water(const Sight& sight);
    glm::dvec3 in_air(const Sight& sight);

    glm::dvec3 at_bottom(const Sight& sight, double& way);
    glm::dvec3 at_water_from_above(const Sight& sight, double way);
    glm::dvec3 at_water_from_below(const Sight& sight, double way);
    glm::dvec3 at_dry(const Sight& sight, const AirMeeting& m);
    glm::dvec3 at_object(const Sight& sight, const SceneHit& hit);
    glm::dvec3 at_glass(const Sight& sight, const SceneHit& hit);
    glm::dvec3 at_diffuse(const Sight& sight, const SceneHit& hit);
    glm::dvec3 sky(const Sight& sight);
    /// What a way sees that is not followed further.
    glm::dvec3 even(const Sight& sight) const;

    AirMeeting meet_in_air(Sight& sight);
    void meet_dry(const Sight& sight, AirMeeting& nearest) const;
    bool beyond_walls(glm::dvec3 place) const;
    WaterPoint water_point(glm::dvec3 place, glm::dvec3 d, double width);

    /// Irradiance of sun and lamp on a plane.
    glm::dvec3 direct(glm::dvec3 place, glm::dvec3 normal, bool in_water);
    glm::dvec3 sun_in_water(glm::dvec3 place, glm::dvec3 normal);
    glm::dvec3 from_lamp(glm::dvec3 place, glm::dvec3 normal, bool in_water);
    /// Diffuse irradiance on a plane.
    glm::dvec3 diffuse(glm::dvec3 place, glm::dvec3 normal, bool in_water);
    /// The part of the diffuse light on a plane that objects do not keep off.
    double open_part(glm::dvec3 place, glm::dvec3 normal, unsigned seed) const;
    /// Of that from one side, relative to what comes there without objects.
    double diffuse_along(Ray ray) const;
    /// What objects leave of light that goes straight, `way` metres from a place.
    double left_by_objects(glm::dvec3 from, glm::dvec3 direction, double way, bool in_water) const;
    double sun_left(glm::dvec3 place) const;

    double index_of(const Traveller& traveller) const;
    double curvature(const SceneHit& hit) const;

    const TracedScene& scene_;
    const WaterScene& water_;
    const TraceOptions& options_;
    f32::SceneText text_;
    std::optional<f32::SceneText> things_;  ///< with the light in the water that things get; none: of calm water
    const SurfaceLevels& levels_;
    bool objects_;
};

}  // namespace waterlight
