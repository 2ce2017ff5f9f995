// Where light went: one account for all that follow it.
#pragma once

#include "caustics/beams.hpp"
#include "caustics/floor.hpp"

namespace waterlight {

/// Powers in watts. incident + entered = reflected + absorbed + scattered + floor + walls + objects + outside + lost.
struct LightLedger {
    double incident_w = 0;   ///< on the surface
    double entered_w = 0;    ///< landed on the map from beyond the domain
    double reflected_w = 0;  ///< by the surface
    double absorbed_w = 0;   ///< by the water on the way
    double scattered_w = 0;  ///< by the water on the way; not followed any further
    double floor_w = 0;
    double walls_w = 0;    ///< on walls that are receivers
    double outside_w = 0;  ///< beyond the map or the domain, walls that are none among it, or on dry ground
    double objects_w = 0;  ///< stopped by objects
    double lost_w = 0;     ///< not followed to its end: beyond the window, or on a discarded triangle

    /// |what is unaccounted for| / (incident + entered); 0 where there is no light.
    double closure() const;
    LightLedger& operator+=(const LightLedger& other);
    LightLedger scaled(double by) const;
};

FloorLedger& operator+=(FloorLedger& to, const FloorLedger& from);

/// What the water extinguishes is absorbed or scattered in the proportion of the two coefficients.
LightLedger light_ledger(const FloorLedger& ledger, const WaterOptics& optics);
LightLedger light_ledger(const BeamLedger& ledger, const WaterOptics& optics);

}  // namespace waterlight
