// What a run says about itself: report.json, and the numbers that checks judge.
#pragma once

#include <limits>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/accuracy_stage.hpp"
#include "app/beam_stage.hpp"
#include "app/flashes.hpp"
#include "app/floor_stage.hpp"
#include "app/judge.hpp"
#include "app/readings.hpp"
#include "app/wall_stage.hpp"
#include "sim/runup.hpp"
#include "sim/shallow_water.hpp"
#include "sim/wave_model.hpp"

namespace waterlight {

/// Seconds of wall time by stage.
struct StageTimes {
    double waves = 0;
    double floor = 0;
    double beams = 0;
    double walls = 0;
    double render = 0;  ///< of pictures of the scene
    double movie = 0;   ///< of them at the end
    double accuracy = 0;
    double diagnostics = 0;
    double export_busy = 0;     ///< of the thread that writes
    double export_blocked = 0;  ///< that computing waited for it
    double total = 0;
};

/// The light that a probe reads, W/m2; what it does not is not a number.
struct ProbeLight {
    double plane_w_m2 = std::numeric_limits<double>::quiet_NaN();   ///< downward, in the water or on the floor
    double scalar_w_m2 = std::numeric_limits<double>::quiet_NaN();  ///< in the water
};

/// One probe over the run.
struct ProbeRecord {
    double elevation = 0, min_elevation = 0, max_elevation = 0;  ///< m
    double late_squares = 0;  ///< sum of elevation squared over the rows of the second half, m2
    int late_frames = 0;
    double irradiance = 0, max_irradiance = 0, scalar_irradiance = 0;
    LightSeries series;  ///< empty where the probe reads no light
    double arrival_s = std::numeric_limits<double>::quiet_NaN();
};

/// The floor map over the run.
struct FloorRecord {
    FloorStatistics last;
    FloorWindow window;  ///< of the last frame
    LightLedger last_ledger;
    LightLedger sum;           ///< over the frames
    double lost_fraction = 0;  ///< largest
    double closure = 0;        ///< largest of a frame
    MethodRecord method;       ///< of the last frame
};

/// The waves over the run.
struct WaveRecord {
    std::string model;
    double still_m3 = 0;  ///< what the volume of the diagnostics leaves out: the water below level 0
    std::int64_t steps = 0;
    WaveDiagnostics first, last;
    double mass_drift_m = 0;
    double energy_drift = 0;  ///< NaN where energy comes in or goes out
};

/// The water of the model shallow-water over the run.
struct ShallowRecord {
    ShallowTotals first, last;
    double volume_drift = 0;  ///< relative; NaN where water comes in or goes out
    double min_depth_m = std::numeric_limits<double>::infinity();
    double inundated_m2 = 0;  ///< of ground that was dry at the start
    std::optional<RunupPoint> highest;
    double exact_l1 = std::numeric_limits<double>::quiet_NaN();  ///< relative, of the depth
};

struct SeaRecord {
    SeaCoverage coverage;
    std::string description;
    double significant_height_m() const;  ///< carried by the grid
};

struct RunRecord {
    int frames = 0;
    double simulated_s = 0;
    StageTimes wall;
    WaveRecord waves;
    std::optional<FloorRecord> floor;
    std::optional<BeamRecord> beams;
    std::optional<AccuracyRecord> accuracy;
    std::optional<WallRecord> walls;
    std::optional<SeaRecord> sea;
    std::string picture_device;  ///< that draws the scene; empty where none does
    std::optional<ShallowRecord> shallow;
    std::map<std::string, ProbeRecord> probes;
};

/// Value by the names of scenarios/quantities.hpp; what the run does not have is not a number.
std::map<std::string, double> quantities_of(const RunRecord& record);

/// FNV-1a, 64 bits (Fowler, Noll, Vo), over the scenario's text and its overrides.
std::string hash_of(const Origin& origin);

/// The report of DESIGN's contract.
nlohmann::ordered_json report_json(const Scenario& scenario, const BackendDecision& backend, const RunRecord& record,
                                   const std::vector<CheckResult>& checks);

}  // namespace waterlight
