// A sloping floor for tests of pictures.
#pragma once

#include <algorithm>
#include <glm/geometric.hpp>

#include "caustics/beams.hpp"
#include "caustics/picture_ground.hpp"

namespace waterlight::test {

struct SlopingPool {
    glm::dvec2 slope{.12, .08};  ///< rise per metre
    double at_origin_m = -3.4;

    double height(glm::dvec2 at) const { return at_origin_m + glm::dot(slope, at); }

    PictureGround ground() const {
        PictureGround g;
        g.height_m = [*this](glm::dvec2 at) { return height(at); };
        g.highest_m = 20;  // to beyond the range of any test
        return g;
    }

    /// Ends every corner's light where its way meets the plane.
    void end(Beams& b) const {
        for (std::size_t i = 0; i < b.z.size(); ++i) {
            const glm::dvec2 at{b.x.data()[i], b.y.data()[i]}, travel{b.travel_x.data()[i], b.travel_y.data()[i]};
            const double z = b.z.data()[i];
            const double descent = (z - height(at)) / (1 + glm::dot(slope, travel));
            b.end_z.data()[i] = static_cast<float>(std::min(z, z - descent));
        }
    }
};

}  // namespace waterlight::test
