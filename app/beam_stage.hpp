// The part of a run that lights the water: beams, fields, pictures.
#pragma once

#include <vector>

#include "caustics/beam_refine.hpp"
#include "caustics/beam_volume.hpp"
#include "scenarios/scenario.hpp"
#include "sim/state_archive.hpp"

namespace waterlight {

/// One horizontal slice of the water over cells and frames.
struct SliceStatistics {
    double depth_m = 0;
    double mean = 0;  ///< downward irradiance, W/m2
    double cv = 0;
    double skewness = 0;
    double flash_fraction = 0;  ///< part above 1.5 times the mean of its frame
};

/// The light in the water over the run.
struct BeamRecord {
    BeamLedger last_ledger, sum;
    double closure = 0;             ///< largest
    double discarded_fraction = 0;  ///< largest
    // Where there are fields:
    std::vector<SliceStatistics> slices;  ///< from the surface down
    double flux_error = 0;                ///< largest
    double brightest_depth_m = 0;         ///< of the last frame
    // Where there is a camera, of the last frame:
    double mean_radiance = 0;
    double max_radiance = 0;
    BeamImageCounts counts;
};

/// Computes on the CPU. The scenario has beams and outlives the stage.
class BeamStage {
  public:
    explicit BeamStage(const Scenario& scenario);

    /// Throws InputError where a setting does not go with the surface.
    void compute(const Surface& surface);
    /// Takes the frame just computed into the record.
    void add_frame();
    BeamRecord record() const;
    /// Gives the record so far to the archive, or takes it from there.
    void exchange_state(StateArchive& state);
    /// Downward irradiance (W/m2) at a place below still water.
    double irradiance_at(glm::dvec2 at_m, double depth_m) const;

    const BeamVolume* volume() const { return scenario_.beams->volume_cells ? &volume_ : nullptr; }
    const BeamImage* image() const { return scenario_.camera ? &image_ : nullptr; }

  private:
    /// Sums of one slice over cells and frames.
    struct Moments {
        double count = 0, sum = 0, squares = 0, cubes = 0, flashes = 0;
    };
    void draw(const Surface& surface);
    void add_volume();
    void add_slice(int k);

    const Scenario& scenario_;
    Beams beams_;
    RefinedBeams refined_;
    BeamVolume volume_;
    BeamImage image_;
    BeamRecord record_;
    std::vector<Moments> moments_;
};

}  // namespace waterlight
