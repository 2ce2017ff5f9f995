// From a scenario to its floor map.
#pragma once

#include <memory>

#include "caustics/sun_disc.hpp"
#include "scenarios/build.hpp"

namespace waterlight {

/// Heights of the ground that the map lies on, on the model's cells; none where it lies on the flat floor.
std::shared_ptr<const Field<float>> receiver_bed(const Scenario& scenario, const BuiltModel& model);

/// Of the methods splat and photons. `floor` is of one wavelength, whose share its sun has of the scenario's; a lamp's
/// intensity is shared likewise.
SplatSettings splat_settings(const Scenario& scenario, const FloorSettings& floor,
                             std::shared_ptr<const Field<float>> bed_m);
PhotonSettings photon_settings(const Scenario& scenario, const FloorSettings& floor,
                               std::shared_ptr<const Field<float>> bed_m);

/// Makes mappers on the CPU by the scenario's method, which is not the truth, of parallel light of one colour. The
/// scenario outlives it.
FloorMaker floor_maker(const Scenario& scenario, std::shared_ptr<const Field<float>> bed_m);

}  // namespace waterlight
