// Light of single vertices on its ways through water and objects.
#pragma once

#include "caustics/objects/water_scene.hpp"
#include "caustics/splat/splat_cloud.hpp"

namespace waterlight {

/// The last part of a way of light.
struct CapturedVertex {
    Flight flight;
    glm::ivec2 vertex{0, 0};  ///< of the lattice
    std::uint64_t way = 0;    ///< tells ways apart: what was met, and whether it was reflected or refracted there
};

/// Follows the light of one vertex after the other.
class LightWays {
  public:
    LightWays(const SplatSettings& settings, const SplatFrame& frame, const WaterScene& scene);
    /// Adds the last parts of a vertex's ways, and what ends otherwise to the account.
    void follow(glm::ivec2 vertex, std::vector<CapturedVertex>& out, FlightAccount& account);

  private:
    /// Light on its way since it met something last.
    struct Way {
        Traveller traveller;
        glm::dvec3 start_m{0, 0, 0};  ///< as if it had not come in again over periodic sides
        double travelled_m = 0;       ///< before it came in again
        double power_w = 0;
        std::uint64_t way = 0;
        int met = 0;
        int wraps = 0;
    };
    std::optional<Way> from_light();
    std::pair<Ray, SceneHit> first_met(const Ray& ray) const;
    void go_on(const Way& way);
    void land(const Way& way, const SceneHit& hit);
    void pass_side(const Way& way, const SceneHit& hit);
    void meet(const Way& way, const SceneHit& hit);
    void branch(const Way& way, const Traveller& on, double power_w, bool reflected, int object);
    bool in_domain(glm::dvec2 at_m) const;
    void count(double& row, double power_w) const {
        if (own_) row += power_w;
    }

    int bounces_;
    const SplatFrame& frame_;
    const WaterScene& scene_;
    double top_m_ = 0;  ///< above all that light can meet
    bool has_objects_ = false;
    // Of the vertex at hand.
    glm::ivec2 vertex_{0, 0};
    bool own_ = true;
    double least_w_ = 0;
    std::vector<Way> pending_;
    std::vector<CapturedVertex>* out_ = nullptr;
    FlightAccount* account_ = nullptr;
};

}  // namespace waterlight
