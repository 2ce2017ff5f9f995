// The files of a run: which there are, and who writes them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "app/run_folder.hpp"
#include "caustics/beam_image.hpp"
#include "caustics/beam_volume.hpp"
#include "caustics/light_ledger.hpp"
#include "caustics/spectral_floor.hpp"
#include "caustics/walls.hpp"
#include "export/legend.hpp"
#include "export/probes.hpp"
#include "export/queue.hpp"
#include "export/range.hpp"
#include "export/series.hpp"
#include "render/look.hpp"
#include "scenarios/scenario.hpp"
#include "sim/runup.hpp"
#include "sim/shallow_water.hpp"
#include "sim/surface.hpp"

namespace waterlight {

/// The scene as the camera sees it.
struct ScenePicture {
    ColourImage image;
    Clipped clipped;  ///< of the overlay's values
};

/// What a frame shows; what the run does not compute is nullptr.
struct FrameView {
    const Surface& surface;
    const FloorMap* floor = nullptr;
    const BeamVolume* volume = nullptr;
    const BeamImage* picture = nullptr;
    const Field<float>* floor_error = nullptr;  ///< of the irradiance, W/m2
    const Field<float>* waves_error = nullptr;  ///< of the elevation, m
    const WallMaps* walls = nullptr;
    std::span<const BandMap> bands = {};  ///< of light in colour
    const ScenePicture* scene = nullptr;
    std::vector<LightLedger> ledgers = {};  ///< of the floor map, the beams and the walls, those there are
};

/// The map of one wavelength.
struct BandFiles {
    double wavelength_nm = 0, share = 1;
    Field<float> irradiance;
};

/// One frame as it is handed over to be written: copies that the run may then forget.
struct FrameFiles {
    Surface surface;
    Field<float> irradiance;            ///< empty without a floor map
    std::vector<BandFiles> bands;       ///< of light in colour
    std::array<Field<float>, 4> walls;  ///< those there are
    Field<float> shown;                 ///< elevation as pictures show it: NaN on dry ground; empty where there is none
    glm::ivec3 volume_cells{0, 0, 0};
    double volume_depth_m = 1;
    Field<float> plane_irradiance, scalar_irradiance;  ///< in the water; empty without fields
    Field<float> radiance;                             ///< empty without a camera
    Field<float> floor_error, waves_error;             ///< empty without an estimate
    ScenePicture scene;                                ///< empty without a picture of it
    std::vector<double> probes;
    std::vector<double> ledgers;  ///< a row of ledger.csv

    std::size_t bytes() const;
};

/// One line that says where a file is and what opens it.
std::string guide_line(const std::filesystem::path& path, const std::string& what);

/// Writes frames into a folder beside the computation. Throws WorldError, then or with a later call.
class Outputs {
  public:
    /// `state` is what a checkpoint kept, or null: from there it goes on with the files that are in the folder.
    Outputs(const RunFolder& folder, const Scenario& scenario, StateArchive* state);

    /// Copies what it needs and returns; waits only while the queue is full.
    void push(const FrameView& view, std::vector<double> probes);
    /// Between frames: a row of probes.csv.
    void push_row(double time_s, std::vector<double> probes);
    /// Writes a checkpoint of `state` and of what was written before, once that is written. There are more frames.
    void push_checkpoint(double time_s, StateArchive state);
    /// At the end: how far the water came, and extremes.vti where the scenario asks for it. Borrows the fields until
    /// finish().
    void push_end(const Grid& grid, double time_s, const Field<float>& bed_m, const ShallowRecords& records,
                  std::vector<RunupLine> lines);
    /// Waits until all is written and makes sure that it is still there.
    void settle();
    /// The same, then removes what an earlier, longer run left under names of ours.
    void finish();

    /// The simulated time of the checkpoint that is there, if any. Waits until all is written, whatever fails.
    std::optional<double> last_checkpoint_s();

    double busy_s() const { return queue_.busy_s(); }
    double blocked_s() const { return queue_.blocked_s(); }
    /// The picture of the scene of a frame, counted from 0.
    std::filesystem::path scene_file(int frame) const;
    /// One line for each kind of file written: where it is and what opens it.
    std::vector<std::string> guide() const;

    static constexpr const char* checkpoint_name = "checkpoint.bin";

  private:
    template <class Job>
    void push_job(std::size_t bytes, Job job);
    /// What goes on from frame to frame.
    void exchange_state(StateArchive& state);
    void require_written() const;
    void write(const FrameFiles& frame);
    void write_fields(const FrameFiles& frame);
    void add_to(VtiSeries& series, const char* name, const VtiFrame& frame);
    void write_pictures(const FrameFiles& frame);
    void write_walls(const FrameFiles& frame);
    void write_wall_pictures(const FrameFiles& frame);
    void write_colour(const FrameFiles& frame);
    void write_radiance(const FrameFiles& frame);
    void write_scene(const FrameFiles& frame);
    void write_greys(const FrameFiles& frame);
    void write_exrs(const FrameFiles& frame);
    /// Of the pictures: as the scenario says, else the largest so far, so that colours do not flicker.
    ValueRange elevation_range(const FrameFiles& frame);
    /// Of the frame at hand.
    std::filesystem::path image(const std::string& name, const char* extension);

    const RunFolder& place_;
    std::filesystem::path folder_;
    OutputSection settings_;
    std::optional<FloorPlan> plan_;
    double depth_m_;
    double wet_m_;
    double irradiance_max_;
    std::optional<ValueRange> elevation_range_;
    VtiSeries surface_series_;
    VtiSeries floor_series_;
    VtiSeries volume_series_;
    VtiSeries walls_series_;
    VtiSeries camera_series_;
    std::optional<WallSettings> walls_;
    bool has_volume_;
    bool has_picture_;
    std::optional<double> radiance_max_;  ///< of the pictures: as the scenario says, else the largest so far
    std::optional<double> radiance_decades_;
    double radiance_so_far_ = 0;
    std::optional<Look> look_;  ///< of pictures of the scene, where there are any
    std::optional<ProbeTable> probes_;
    std::optional<ProbeTable> ledgers_;                 ///< where light is followed
    std::uint64_t probe_bytes_ = 0, ledger_bytes_ = 0;  ///< of both, at the checkpoint
    std::optional<double> checkpoint_s_;
    bool has_end_ = false;
    int frame_ = 0;
    std::set<std::filesystem::path> written_;
    ExportQueue queue_;  ///< last: its thread uses all of the above
};

}  // namespace waterlight
