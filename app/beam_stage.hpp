// The part of a run that lights the water: beams, fields, pictures.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "caustics/beam_ground.hpp"
#include "caustics/beam_point.hpp"
#include "caustics/beam_renderer.hpp"
#include "caustics/light_ledger.hpp"
#include "scenarios/build.hpp"
#include "scenarios/resolve.hpp"
#include "sim/state_archive.hpp"

namespace waterlight {

/// One horizontal slice of the water over cells above the ground and frames.
struct SliceStatistics {
    double depth_m = 0;
    double mean = 0;  ///< downward irradiance, W/m2
    double cv = 0;
    double skewness = 0;
    double flash_fraction = 0;  ///< part above 1.5 times the mean of its frame
    double flash_rate_hz = 0;   ///< at which a cell rises above that level, from frame to frame
    double water_fraction = 1;  ///< part of the slice above the ground, of which the numbers above are
};

/// The light in the water over the run.
struct BeamRecord {
    std::string backend;  ///< of pictures and fields
    LightLedger last_ledger, sum;
    double closure = 0;                        ///< largest
    double discarded_fraction = 0;             ///< largest
    BeamLedger last_reflected, sum_reflected;  ///< of the beams above the water, where there are any
    // Where there are fields:
    std::vector<SliceStatistics> slices;  ///< from the surface down
    double flux_error = 0;                ///< largest
    double brightest_depth_m = 0;         ///< of the last frame
    double sampled_every_s = 0;           ///< the longest time between frames
    // Where a camera sees them, of the last frame:
    double mean_radiance = 0;
    double max_radiance = 0;
    BeamImageCounts counts;
};

/// Makes the beams on the CPU; the renderer draws them and fills fields. The scenario has beams and outlives the stage.
class BeamStage {
  public:
    /// The model gives the ground where it has one. Throws InputError where a file of the ground cannot be used.
    BeamStage(const Scenario& scenario, const BuiltModel& model, std::unique_ptr<BeamRenderer> renderer);

    /// Throws InputError where a setting does not go with the surface.
    void compute(const Surface& surface);
    /// Takes the frame just computed into the record.
    void add_frame(double time_s);
    /// The beams alone: between frames, for irradiance_at(). Throws as compute().
    void compute_beams(const Surface& surface);
    /// Heights of the ground that beams end on; null over a flat floor.
    const BeamGround* ground() const { return ground_.get(); }
    BeamRecord record() const;
    /// Of the last frame taken into the record.
    const LightLedger& ledger() const { return record_.last_ledger; }
    /// Of the beams computed last, whether taken into the record or not.
    LightLedger frame_ledger() const { return light_ledger(beams_.ledger, scenario_.optics); }
    /// Gives the record so far to the archive, or takes it from there.
    void exchange_state(StateArchive& state);
    /// At a place below still water, of the beams computed last.
    PointIrradiance irradiance_at(glm::dvec2 at_m, double depth_m) const;

    const BeamVolume* volume() const { return scenario_.beams->volume_cells ? &volume_ : nullptr; }
    const BeamImage* image() const { return sees_scattered_light(scenario_) ? &image_ : nullptr; }

  private:
    /// Sums of one slice over cells and frames.
    struct Moments {
        double count = 0, cells = 0, sum = 0, squares = 0, cubes = 0, flashes = 0;
        double rises = 0;      ///< of cells above the level of a flash, from one frame to the next
        double watched_s = 0;  ///< time between frames, summed over cells
    };
    BeamSettings settings() const;
    PictureGround picture_ground() const;
    void draw(const Surface& surface);
    void add_volume(double time_s);
    void add_slice(int k, double since_s);
    void watch_flashes(int k, double level);

    const Scenario& scenario_;
    std::shared_ptr<const BeamGround> ground_;  ///< none: a flat floor
    std::unique_ptr<BeamRenderer> renderer_;
    Beams beams_;
    Beams reflected_;
    RefinedBeams refined_;
    BeamVolume volume_;
    BeamImage image_;
    BeamRecord record_;
    std::vector<Moments> moments_;
    std::vector<char> flashing_;  ///< whether a cell was above that level in the frame before
    double last_frame_s_ = 0;
};

}  // namespace waterlight
