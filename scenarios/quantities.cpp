#include "scenarios/quantities.hpp"

#include <algorithm>
#include <array>

#include "scenarios/scenario.hpp"

namespace waterlight {

namespace {

constexpr std::array of_run{
    Quantity{"simulated_s", "s", "time that the run covers"},
    Quantity{"waves.steps", "", "sub-steps that the wave model took"},
    Quantity{"waves.significant_height", "m", "four times the root of the variance of the elevation"},
    Quantity{"waves.max_elevation", "m", "largest elevation or depression"},
    Quantity{"waves.slope_variance", "", "mean square slope"},
    Quantity{"waves.mass_drift", "m", "largest change of the mean level over the run"},
    Quantity{"waves.energy_drift", "",
             "largest relative change of the energy once all drops have fallen; closed water without a wavemaker or "
             "friction only"},
    Quantity{"waves.volume_drift", "",
             "largest change of the water's volume over its volume at the start; closed sides"},
    Quantity{"waves.momentum_x", "kg m/s", "of the water"},
    Quantity{"waves.momentum_y", "kg m/s", "of the water"},
    Quantity{"waves.energy", "J", "kinetic, and potential above that of water still at level 0"},
    Quantity{"waves.inundated_area", "m2", "of ground that was dry at the start and came under water since"},
    Quantity{"waves.max_runup", "m", "height of the highest ground that ever was under water"},
    Quantity{"waves.min_depth", "m", "least depth of any cell over the frames; never below zero"},
    Quantity{"waves.exact_l1", "", "relative L1 error of the depth against the exact state that waves.initial states"},
    Quantity{"sea.significant_height", "m", "of that part of the spectrum which the grid carries"},
    Quantity{"sea.longer_fraction", "", "part of the spectrum's variance in waves longer than the domain"},
    Quantity{"sea.shorter_fraction", "", "part of the spectrum's variance in waves shorter than two cells"},
    Quantity{"sea.height_error", "",
             "relative difference of the initial surface's significant height from the carried"},
    Quantity{"floor.mean_irradiance", "W/m2", "mean over the map"},
    Quantity{"floor.min_irradiance", "W/m2", "darkest pixel"},
    Quantity{"floor.max_irradiance", "W/m2", "brightest pixel"},
    Quantity{"floor.cv", "", "coefficient of variation over the map: standard deviation / mean"},
    Quantity{"floor.lost_fraction", "", "largest part of the light over the run that landed beyond the window"},
    Quantity{"floor.ledger_closure", "", "largest part of the light over the run that is unaccounted for"},
    Quantity{"floor.truth_error", "", "the truth's own estimate of its relative error"},
    Quantity{"accuracy.floor.estimated_rmse", "", "estimated relative RMSE of the last map; with accuracy.estimate"},
    Quantity{"accuracy.waves.estimated_rmse", "",
             "estimated relative RMSE of the elevation at the end; with accuracy.estimate, not of model prescribed"},
    Quantity{"beams.ledger_closure", "", "largest part of the light over the run that is unaccounted for"},
    Quantity{"beams.discarded_fraction", "", "largest part of the light over the run on discarded triangles"},
    Quantity{"volume.flux_error", "",
             "largest part of a slice's light over the run that is neither on its cells nor beyond a side"},
    Quantity{"volume.mean_irradiance", "W/m2", "downward, mean over the deepest slice and the frames"},
    Quantity{"volume.brightest_depth", "m", "depth of the cell of greatest downward irradiance"},
    Quantity{"volume.max_cv", "", "largest coefficient of variation of any slice over cells and frames"},
    Quantity{"volume.max_cv_depth", "m", "depth of that slice"},
    Quantity{"volume.max_skewness", "", "largest skewness of any slice over cells and frames"},
    Quantity{"volume.max_flash_fraction", "", "largest part of any slice above 1.5 times its mean"},
    Quantity{"camera.mean_radiance", "W/(m2 sr)", "mean over the picture"},
    Quantity{"camera.max_radiance", "W/(m2 sr)", "brightest pixel"},
};

constexpr std::array of_probe{
    Quantity{"elevation", "m", "at the end"},
    Quantity{"min_elevation", "m", "least over the rows of probes.csv"},
    Quantity{"max_elevation", "m", "greatest over the rows of probes.csv"},
    Quantity{"rms_elevation", "m", "root mean square over the rows of the second half of the run"},
    Quantity{"arrival_time", "s", "when the water came, or first rose by waves.wet_m; model shallow-water"},
    Quantity{"irradiance", "W/m2", "downward on the floor below, or at the probe's depth, at the end"},
    Quantity{"max_irradiance", "W/m2", "the same, greatest over the frames"},
};

// What the model shallow-water alone has.
constexpr std::array of_shallow_water{"waves.volume_drift",   "waves.momentum_x", "waves.momentum_y", "waves.energy",
                                      "waves.inundated_area", "waves.max_runup",  "waves.min_depth",  "waves.exact_l1"};

}  // namespace

bool is_of_shallow_water(std::string_view quantity) {
    return std::find(of_shallow_water.begin(), of_shallow_water.end(), quantity) != of_shallow_water.end() ||
           quantity.ends_with(".arrival_time");
}

std::span<const Quantity> run_quantities() { return of_run; }
std::span<const Quantity> probe_quantities() { return of_probe; }

std::vector<std::string> quantity_names(const Scenario& scenario) {
    std::vector<std::string> names;
    for (const Quantity& quantity : of_run) names.emplace_back(quantity.name);
    for (const Probe& probe : scenario.probes)
        for (const Quantity& quantity : of_probe)
            names.push_back("probe." + probe.name + "." + std::string(quantity.name));
    return names;
}

}  // namespace waterlight
