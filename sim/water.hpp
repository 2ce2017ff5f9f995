// The water as waves feel it.
#pragma once

namespace waterlight {

/// SI units. Defaults: fresh water at 20 degrees Celsius and standard terrestrial gravity to three digits.
struct Water {
    double depth_m = 1;                   ///< > 0; infinity is allowed (deep water)
    double gravity_m_s2 = 9.81;           ///< > 0
    double density_kg_m3 = 1000;          ///< > 0
    double surface_tension_n_m = 0.0728;  ///< >= 0
};

}  // namespace waterlight
