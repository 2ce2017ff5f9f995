// Short ways to maps of photons and what they hold.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "caustics/photons/photons.hpp"

namespace waterlight::test {

/// The map over a grid under this sun.
inline PhotonSettings photons_over(const Grid& grid, int width, int height, double elevation_deg) {
    PhotonSettings s;
    s.floor.plan = cover(grid, width, height);
    s.floor.sun = {elevation_deg, 25, 1000};
    return s;
}

struct PhotonResult {
    FloorMap map;
    double error = 0;  ///< by its own estimate
    int passes = 0;
};

inline PhotonResult photon_map(const PhotonSettings& settings, const Surface& surface) {
    PhotonResult result;
    const auto floor = make_photon_floor(settings);
    floor->compute(surface, result.map);
    result.error = floor->error_estimate();
    result.passes = floor->passes();
    return result;
}

inline std::shared_ptr<const ObjectSet> objects(std::vector<Object> all) {
    return std::make_shared<ObjectSet>(std::move(all));
}

inline double mean(const Field<float>& map) {
    double sum = 0;
    for (const float value : map.values()) sum += value;
    return sum / static_cast<double>(map.size());
}

/// Root mean square of a - b over that of b.
template <class A, class B>
double relative_difference(const Field<A>& a, const Field<B>& b) {
    double difference = 0, square = 0;
    for (std::size_t i = 0; i < b.size(); ++i) {
        const double d = double(a.data()[i]) - double(b.data()[i]);
        difference += d * d;
        square += double(b.data()[i]) * double(b.data()[i]);
    }
    return std::sqrt(difference / square);
}

}  // namespace waterlight::test
