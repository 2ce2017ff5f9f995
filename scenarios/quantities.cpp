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
    Quantity{"waves.volume", "m3", "of the water, its mass over its density"},
    Quantity{"waves.energy", "J",
             "kinetic, potential above that of water still at level 0, and of the surface's tension; not of the model "
             "prescribed"},
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
    Quantity{"floor.photon_error", "", "the same of method photons"},
    Quantity{"floor.splat_missed", "", "part of the vertices of method splat that found no receiver"},
    Quantity{"floor.splat_not_converged", "", "part of them whose landing had not come to rest"},
    Quantity{"accuracy.floor.estimated_rmse", "", "estimated relative RMSE of the last map; with accuracy.estimate"},
    Quantity{"accuracy.waves.estimated_rmse", "",
             "estimated relative RMSE of the elevation at the end; with accuracy.estimate, not of model prescribed"},
    Quantity{"beams.ledger_closure", "", "largest part of the light over the run that is unaccounted for"},
    Quantity{"beams.discarded_fraction", "", "largest part of the light over the run on discarded triangles"},
    Quantity{"beams.reflected_fraction", "", "part of the light that the surface reflects, over the frames"},
    Quantity{"walls.ledger_closure", "", "largest part of the light over the run that is unaccounted for"},
    Quantity{"walls.west", "W", "light on the wall of least x"},
    Quantity{"walls.east", "W", "light on the wall of greatest x"},
    Quantity{"walls.south", "W", "light on the wall of least y"},
    Quantity{"walls.north", "W", "light on the wall of greatest y"},
    Quantity{"volume.flux_error", "",
             "largest part of a slice's light over the run that is neither on its cells nor beyond a side"},
    Quantity{"volume.mean_irradiance", "W/m2", "downward, mean over the deepest slice and the frames"},
    Quantity{"volume.brightest_depth", "m", "depth of the cell of greatest downward irradiance"},
    Quantity{"volume.max_cv", "", "largest coefficient of variation of any slice over cells and frames"},
    Quantity{"volume.max_cv_depth", "m", "depth of that slice"},
    Quantity{"volume.max_skewness", "", "largest skewness of any slice over cells and frames"},
    Quantity{"volume.max_flash_fraction", "", "largest part of any slice above 1.5 times its mean"},
    Quantity{"volume.max_flash_rate", "1/s",
             "largest rate of any slice at which a cell rises above 1.5 times its mean, from frame to frame"},
    Quantity{"floor.ledger.incident", "W", "where the light on the water went, of one frame: all of it"},
    Quantity{"floor.ledger.entered", "W", "through the sides"},
    Quantity{"floor.ledger.reflected", "W", "at the surface"},
    Quantity{"floor.ledger.absorbed", "W", "by the water on the way"},
    Quantity{"floor.ledger.scattered", "W", "by the water on the way"},
    Quantity{"floor.ledger.floor", "W", "on the map"},
    Quantity{"floor.ledger.outside", "W", "beyond the map or the domain"},
    Quantity{"floor.ledger.objects", "W", "stopped by objects"},
    Quantity{"floor.ledger.lost", "W", "not followed to its end"},
    Quantity{"beams.ledger.incident", "W", "the same of the beams' grid: all light on it"},
    Quantity{"beams.ledger.reflected", "W", "at the surface"},
    Quantity{"beams.ledger.absorbed", "W", "by the water on the way"},
    Quantity{"beams.ledger.scattered", "W", "by the water on the way"},
    Quantity{"beams.ledger.floor", "W", "on the floor"},
    Quantity{"beams.ledger.outside", "W", "beyond the map or the domain"},
    Quantity{"beams.ledger.objects", "W", "stopped by objects"},
    Quantity{"beams.ledger.lost", "W", "not followed to its end"},
    Quantity{"walls.ledger.incident", "W", "the same of the walls: all light on the water"},
    Quantity{"walls.ledger.reflected", "W", "at the surface"},
    Quantity{"walls.ledger.absorbed", "W", "by the water on the way"},
    Quantity{"walls.ledger.scattered", "W", "by the water on the way"},
    Quantity{"walls.ledger.floor", "W", "on the floor"},
    Quantity{"walls.ledger.walls", "W", "on the walls"},
    Quantity{"walls.ledger.outside", "W", "beyond the map or the domain"},
    Quantity{"walls.ledger.objects", "W", "stopped by objects"},
    Quantity{"walls.ledger.lost", "W", "not followed to its end"},
    Quantity{"camera.mean_radiance", "W/(m2 sr)", "mean over the picture"},
    Quantity{"camera.max_radiance", "W/(m2 sr)", "brightest pixel"},
};

constexpr std::array of_probe{
    Quantity{"elevation", "m", "at the time of the value"},
    Quantity{"min_elevation", "m", "least over the rows of probes.csv"},
    Quantity{"max_elevation", "m", "greatest over the rows of probes.csv"},
    Quantity{"rms_elevation", "m", "root mean square over the rows of the second half of the run"},
    Quantity{"arrival_time", "s", "when the water came, or first rose by waves.wet_m; model shallow-water"},
    Quantity{"irradiance", "W/m2", "downward on the floor below, or at the probe's depth"},
    Quantity{"max_irradiance", "W/m2", "the same, greatest over the rows of probes.csv"},
    Quantity{"mean_irradiance", "W/m2", "the same, mean over time"},
    Quantity{"irradiance_cv", "", "its coefficient of variation in time: standard deviation / mean"},
    Quantity{"irradiance_skewness", "", "its skewness in time"},
    Quantity{"flash_rate", "1/s", "at which it rises above 1.5 times its mean over time"},
    Quantity{"longest_flash", "s", "that it stays above"},
    Quantity{"scalar_irradiance", "W/m2", "at the probe's depth"},
    Quantity{"significant_height", "m", "four standard deviations of the elevation over the rows of the window"},
    Quantity{
        "peak_period", "s",
        "of the elevation's spectrum S over the rows of the window: integral of S^4 over that of f S^4 (Young 1995)"},
};

constexpr std::array fields{
    Quantity{"surface.elevation", "m", "above still water; on dry ground that of the ground"},
    Quantity{"surface.slope_x", "", "d elevation / dx"},
    Quantity{"surface.slope_y", "", "d elevation / dy"},
    Quantity{"surface.depth", "m", "of the water"},
    Quantity{"surface.velocity_x", "m/s", "of the water; model shallow-water"},
    Quantity{"surface.velocity_y", "m/s", "of the water; model shallow-water"},
    Quantity{"floor.irradiance", "W/m2", "of the floor's map"},
    Quantity{"volume.plane_irradiance", "W/m2", "downward in the water"},
    Quantity{"volume.scalar_irradiance", "W/m2", "from all directions in the water"},
    Quantity{"camera.radiance", "W/(m2 sr)", "of the picture"},
};

// In the unit of the field, the relative ones without.
constexpr std::array statistics{
    Quantity{"min", "", "least value"},
    Quantity{"max", "", "greatest value"},
    Quantity{"mean", "", "mean"},
    Quantity{"rms", "", "root of the mean square"},
    Quantity{"l1", "", "mean of the absolute value"},
    Quantity{"l2", "", "root of the mean square"},
    Quantity{"linf", "", "greatest absolute value"},
    Quantity{"relative_l1", "", "l1 over that of the reference"},
    Quantity{"relative_l2", "", "l2 over that of the reference"},
    Quantity{"relative_linf", "", "linf over that of the reference"},
};

// What the model shallow-water alone has.
constexpr std::array of_shallow_water{"waves.volume_drift",   "waves.momentum_x",   "waves.momentum_y",
                                      "waves.inundated_area", "waves.max_runup",    "waves.min_depth",
                                      "waves.exact_l1",       "surface.velocity_x", "surface.velocity_y"};

// What tells of the run so far, and not of one frame.
constexpr std::array of_run_so_far{"simulated_s",
                                   "waves.steps",
                                   "waves.mass_drift",
                                   "waves.energy_drift",
                                   "waves.volume_drift",
                                   "waves.inundated_area",
                                   "waves.max_runup",
                                   "waves.min_depth",
                                   "sea.",
                                   "floor.lost_fraction",
                                   "floor.ledger_closure",
                                   "beams.ledger_closure",
                                   "beams.discarded_fraction",
                                   "beams.reflected_fraction",
                                   "walls.ledger_closure",
                                   "volume.flux_error",
                                   "volume.mean_irradiance",
                                   "volume.max_",
                                   ".min_elevation",
                                   ".max_elevation",
                                   ".rms_elevation",
                                   ".arrival_time",
                                   ".max_irradiance",
                                   ".mean_irradiance",
                                   ".irradiance_cv",
                                   ".irradiance_skewness",
                                   ".flash_rate",
                                   ".longest_flash"};

bool is_probes(std::string_view quantity) { return quantity.starts_with("probe."); }

bool is_named(std::string_view quantity, std::string_view part) {
    return part.front() == '.' ? is_probes(quantity) && quantity.ends_with(part) : quantity.starts_with(part);
}

}  // namespace

bool is_of_light(std::string_view quantity) {
    for (const char* end : {"irradiance", ".irradiance_cv", ".irradiance_skewness", ".flash_rate", ".longest_flash"})
        if (quantity.ends_with(end)) return true;
    return false;
}

bool is_of_shallow_water(std::string_view quantity) {
    const auto is_this = [quantity](std::string_view name) { return is_named(quantity, name); };
    return std::any_of(of_shallow_water.begin(), of_shallow_water.end(), is_this) ||
           is_named(quantity, ".arrival_time");
}

std::span<const Quantity> run_quantities() { return of_run; }
std::span<const Quantity> probe_quantities() { return of_probe; }
std::span<const Quantity> field_quantities() { return fields; }
std::span<const Quantity> field_statistics() { return statistics; }

QuantityKind kind_of(std::string_view quantity) {
    if (field_statistic(quantity)) return QuantityKind::of_field;
    const bool is_spectral = is_named(quantity, ".significant_height") || is_named(quantity, ".peak_period");
    if (is_spectral) return QuantityKind::of_series;
    const auto is_this = [quantity](std::string_view name) { return is_named(quantity, name); };
    const bool so_far = std::any_of(of_run_so_far.begin(), of_run_so_far.end(), is_this);
    return so_far ? QuantityKind::of_run : QuantityKind::of_frame;
}

std::optional<FieldStatistic> field_statistic(std::string_view quantity) {
    const std::size_t dot = std::min(quantity.rfind('.'), quantity.size());
    const auto is = [](std::string_view name) { return [name](const Quantity& q) { return q.name == name; }; };
    const std::string_view field = quantity.substr(0, dot),
                           statistic = quantity.substr(std::min(dot + 1, quantity.size()));
    if (std::none_of(fields.begin(), fields.end(), is(field))) return std::nullopt;
    if (std::none_of(statistics.begin(), statistics.end(), is(statistic))) return std::nullopt;
    return FieldStatistic{field, statistic};
}

bool is_written(std::string_view field) {
    return field == "surface.elevation" || field == "surface.depth" || field == "floor.irradiance" ||
           field == "camera.radiance" || field.starts_with("volume.");
}

bool is_row_quantity(std::string_view quantity) { return is_named(quantity, ".elevation"); }

std::vector<std::string> quantity_names(const Scenario& scenario) {
    std::vector<std::string> names;
    for (const Quantity& quantity : of_run) names.emplace_back(quantity.name);
    for (const Probe& probe : scenario.probes)
        for (const Quantity& quantity : of_probe)
            names.push_back("probe." + probe.name + "." + std::string(quantity.name));
    for (const Quantity& field : fields)
        for (const Quantity& statistic : statistics)
            names.push_back(std::string(field.name) + "." + std::string(statistic.name));
    return names;
}

}  // namespace waterlight
