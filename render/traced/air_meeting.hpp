// What a way of sight through the air meets first.
#pragma once

#include <limits>

#include "render/traced/tracer.hpp"

namespace waterlight {

struct Tracer::AirMeeting {
    enum class What { sky, water, object, wall, deck, ground };
    What what = What::sky;
    double way = std::numeric_limits<double>::infinity();
    int wall = -1;
    SceneHit hit{};  ///< of an object
};

}  // namespace waterlight
