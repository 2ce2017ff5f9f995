// What a session shows at one moment: everything that a picture and a panel need. Nobody changes it once it is
// published, and who holds it may keep it as long as he likes.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "app/floor_stage.hpp"
#include "caustics/beam_image.hpp"
#include "caustics/beam_volume.hpp"
#include "caustics/floor.hpp"
#include "caustics/light_ledger.hpp"
#include "caustics/walls.hpp"
#include "render/scene.hpp"
#include "scenarios/scenario.hpp"
#include "sim/surface.hpp"

namespace waterlight {

/// A ball that is dragged through the water.
struct HeldSphere {
    glm::dvec3 centre_m{0, 0, 0};
    double radius_m = 0.25;  ///< > 0
};

/// Wall time that the last frame took, ms; 0 for what was not computed in it.
struct StageCosts {
    double waves_ms = 0, floor_ms = 0, beams_ms = 0, walls_ms = 0, estimate_ms = 0;
    double total_ms() const { return waves_ms + floor_ms + beams_ms + walls_ms + estimate_ms; }
};

/// Relative RMSE as AccuracyRecord has them, and of which moment: an estimate is dearer than a frame and is not made
/// for every one. NaN where there is none.
struct ErrorEstimates {
    double floor_rmse = std::numeric_limits<double>::quiet_NaN();
    double waves_rmse = std::numeric_limits<double>::quiet_NaN();
    double time_s = std::numeric_limits<double>::quiet_NaN();
};

/// One wavelength's part of the floor map.
struct BandIrradiance {
    Band band;
    Field<float> irradiance;  ///< W/m2, on the pixels of the floor map
};

struct Snapshot {
    std::uint64_t number = 0;   ///< counts the snapshots of a session, from 1
    std::uint64_t command = 0;  ///< the last of the session's commands that it knows of
    double time_s = 0;          ///< simulated, since the start or the last reset
    std::int64_t steps = 0;     ///< of the wave model
    /// The settings it was made with, the sun and all changes included. Never null.
    std::shared_ptr<const Scenario> scenario;
    BackendDecision backend;  ///< without its context

    Surface surface;
    /// Heights of the ground (m) in the middle of the surface's cells; null over a flat floor.
    std::shared_ptr<const Field<float>> ground_m;
    FloorMap floor;
    FloorPlan floor_plan;
    std::vector<BandIrradiance> bands;  ///< where the scenario's light is in colour: their sum is the floor map
    WallMaps walls;
    WallSettings wall_settings;
    BeamVolume volume;
    BeamImage beams;                   ///< single-scattered light towards beams_camera
    Camera beams_camera;               ///< the camera of `beams`, its size included
    Field<float> floor_error;          ///< estimated: W/m2 to subtract, on the floor map's pixels
    Field<float> waves_error;          ///< estimated: m to subtract, on the surface's cells
    std::optional<HeldSphere> sphere;  ///< while one is held

    /// What of the above was computed; the rest is empty or of an earlier moment.
    struct Contents {
        bool floor = false, walls = false, volume = false, beams = false, floor_error = false, waves_error = false;
    } has;

    LightLedger floor_ledger, beams_ledger, walls_ledger;  ///< of what it has
    StageCosts costs;
    ErrorEstimates estimates;

    /// What a SceneRenderer takes, of what it has: borrowed from this snapshot. The floor is in colour where there are
    /// three bands, the longest wavelength for red.
    Scene scene() const;
};

}  // namespace waterlight
