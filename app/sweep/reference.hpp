// What the settings of one scene are judged against: the most complete waves, and the true light below them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/sweep/settings.hpp"
#include "caustics/truth.hpp"

namespace waterlight {

/// Where and when settings are compared.
struct Comparison {
    glm::ivec2 raster{0, 0};         ///< pixels of maps; 0 where there are none
    glm::ivec2 points{1, 1};         ///< cells of elevations
    std::vector<double> times_s;     ///< in order
    std::vector<std::string> cells;  ///< overrides of the finest grid of any setting, where the refinement begins
    std::vector<std::string> model;  ///< overrides of the most complete model of any setting
};

/// Of all settings.
Comparison comparison_of(const SweepOptions& options, const std::vector<Variation>& variations,
                         const std::vector<Setting>& settings);

/// One field for each time.
struct Reference {
    std::vector<Field<float>> elevation_m;  ///< at the points
    std::vector<Field<float>> irradiance;   ///< W/m2 on the raster; empty where there is none
    std::string description;
};

/// Reads it from below `folder` or computes and keeps it there; of several processes one computes. The surface is the
/// formula where the model is prescribed by one. Else the scene is run with the most complete model and with cells that
/// are halved until elevation and slope change by less than options.reference_tolerance, at most three times or as far
/// as memory goes; options.reference overrides all that, and where it states domain.cells nothing is halved. Throws
/// InputError where it is no valid scenario.
Reference reference_of(const SweepOptions& options, const Comparison& comparison, const Setting& setting,
                       const std::filesystem::path& folder);

/// The truth on a raster.
struct RasterTruth {
    Field<float> irradiance;    ///< W/m2
    double error_estimate = 0;  ///< relative
};
RasterTruth truth_on(const Scenario& scenario, glm::ivec2 raster, const TruthSurface& surface, double tolerance);

}  // namespace waterlight
