// The light of a session: all that is computed from a surface.
#pragma once

#include <memory>
#include <optional>

#include "app/beam_stage.hpp"
#include "app/floor_estimate.hpp"
#include "app/floor_stage.hpp"
#include "app/readings.hpp"
#include "app/view/snapshot.hpp"
#include "app/wall_stage.hpp"

namespace waterlight {

/// The camera for which scattered light is drawn, where it is below still water; from above, fields in the water are
/// computed in its place.
struct BeamView {
    Camera camera;
    int samples = 1;    ///< as of BeamImageSettings, and the next
    int reduction = 2;  ///< >= 1
};

/// What is computed of a frame, where the settings have it.
enum class LightPart { floor, beams, walls };

class WaterLight {
  public:
    /// Of one scenario; `waves` gives the ground and the formula of the surface, and outlives it. Throws InputError or
    /// gpu::Error.
    WaterLight(std::shared_ptr<const Scenario> scenario, const BuiltModel& waves, const BackendDecision& backend);

    /// From now on.
    void look(const std::optional<BeamView>& view) { view_ = view; }
    void compute(LightPart part, bool on) { is_on_[static_cast<std::size_t>(part)] = on; }

    /// Fills what the snapshot has of light, but for errors. Throws InputError where a setting does not go with the
    /// surface, WorldError where a number is not finite.
    void show(const Surface& surface, std::int64_t step, Snapshot& to);
    /// Estimates the error of the floor map just shown. Does nothing where the scenario asks for none.
    void estimate(const Surface& surface, const FloorMap& map);
    /// Fills in the last estimate.
    void show_estimate(Snapshot& to) const;

  private:
    bool is_on(LightPart part) const { return is_on_[static_cast<std::size_t>(part)]; }
    void show_floor(const Surface& surface, const Instant& now, Snapshot& to);
    void show_beams(const Surface& surface, const Instant& now, Snapshot& to);
    void show_walls(const Surface& surface, const Instant& now, Snapshot& to);
    void aim_beams();

    std::shared_ptr<const Scenario> scenario_;
    Scenario lit_;  ///< the same, with what beams are to be computed for at present
    const SurfaceFormula* formula_;
    std::shared_ptr<const Field<float>> ground_m_;
    std::unique_ptr<FloorStage> floor_;
    std::optional<BeamStage> beams_;
    std::optional<WallStage> walls_;
    std::optional<FloorEstimate> estimate_;
    bool is_estimated_ = false;
    std::optional<BeamView> view_;
    std::array<bool, 3> is_on_{true, true, true};
};

}  // namespace waterlight
