// Triangles, and which of them a ray meets first: by Embree, the place by the triangle's plane in double precision.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "caustics/objects/object_set.hpp"

namespace waterlight {

class TriangleScene {
  public:
    struct Hit {
        double distance_m = 0;
        int triangle = 0;
        glm::dvec3 shares{0, 0, 0};  ///< of the three corners in the place
        glm::dvec3 normal{0, 0, 1};  ///< of the plane, by the order of its corners
    };

    /// Throws WorldError where Embree fails, for want of memory say.
    TriangleScene(std::vector<glm::dvec3> corners_m, std::vector<glm::ivec3> triangles);
    ~TriangleScene();
    TriangleScene(TriangleScene&&) noexcept;
    TriangleScene& operator=(TriangleScene&&) noexcept;

    /// Any number of threads at once.
    std::optional<Hit> first_hit(const Ray& ray) const;

    const std::vector<glm::dvec3>& corners_m() const;
    const std::vector<glm::ivec3>& triangles() const;

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace waterlight
