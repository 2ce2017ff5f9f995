// How the pictures of a scenario's scene look.
#pragma once

#include "scenarios/scenario.hpp"

namespace waterlight {

/// As [picture] says, with the range of its overlay: what is left open is that of the flat pictures, chosen before the
/// run so that no frame depends on those before it. Of elevations output.elevation_max_m, else twice the amplitude of
/// the waves that the scenario states; of irradiance output.irradiance_max_w_m2, else three times that below flat
/// water; of errors a tenth of that. Elevations and errors go as far below zero. Throws InputError where an elevation's
/// is left open and no wave is known.
Look look_of(const Scenario& scenario);

/// Irradiance (W/m2) at the bright end of the pictures' colours.
double irradiance_max(const Scenario& scenario);

}  // namespace waterlight
