// What a method says of its last map.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "app/lit_mapper.hpp"

namespace waterlight {

/// Numbers of methods that others lack; over all wavelengths.
struct MethodRecord {
    FloorMethod method = FloorMethod::two_pass;
    /// The method's own estimate of its relative error; NaN where it has none.
    double error_estimate = std::numeric_limits<double>::quiet_NaN();
    // Of photons:
    int passes = 0;
    std::int64_t photons = 0;
    // Of splat:
    SplatReport splat{};

    /// Parts of the vertices; NaN where there are none.
    double not_converged_fraction() const;
    double missed_fraction() const;
};

/// Of the map just computed by `lit`.
MethodRecord method_record(FloorMethod method, const LitMapper& lit, const FloorMap& map);

}  // namespace waterlight
