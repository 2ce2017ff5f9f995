// A session without its thread and its clock: water and light that take commands between frames.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/view/edits.hpp"
#include "app/view/moving_water.hpp"
#include "app/view/snapshot.hpp"
#include "app/view/water_light.hpp"

namespace waterlight {

/// Every command throws InputError where it is refused, and has then changed nothing; what else it throws is a failure
/// of the run, but where it builds: set(), set_device() and reset() change nothing whatever they throw.
class Simulation {
  public:
    /// Builds the scenario at time 0 and computes its first frame. Throws InputError, WorldError or gpu::Error.
    Simulation(const Scenario& scenario, const DeviceWish& device);

    /// As the functions of Session that have these names.
    void drop(glm::dvec2 at_m, double radius_m, double height_m);
    void hold_sphere(const HeldSphere& sphere);
    void move_sphere(glm::dvec3 centre_m);
    void release_sphere() { sphere_.reset(); }
    void rain(std::optional<double> drops_per_m2_s);
    void sun(double elevation_deg, double azimuth_deg);
    void look(const std::optional<BeamView>& view);
    void compute(LightPart part, bool on);
    void reset();
    void set(const std::vector<std::string>& overrides);
    void set_device(const DeviceWish& device);

    /// Moves the water. Throws WorldError or gpu::Error.
    void advance(double seconds);
    /// The present moment, with a new estimate of the errors where the scenario asks for one and `estimates`, else with
    /// the last. Throws WorldError where a number is not finite, gpu::Error where the device fails.
    void show(Snapshot& to, bool estimates);

    /// After a failure nothing is kept by what is built next.
    void give_up() { failed_ = true; }

    const std::shared_ptr<const Scenario>& scenario() const { return run_.scenario; }
    const Edits& edits() const { return edits_; }
    /// As SessionStatus has it.
    const std::string& note() const { return note_; }

  private:
    /// What is built of one scenario.
    struct Built {
        std::shared_ptr<const Scenario> scenario;
        BackendDecision backend;
        std::shared_ptr<MovingWater> water;  ///< before the light, which refers to it
        std::unique_ptr<WaterLight> light;
    };
    enum class Keep { water, state, nothing };

    Keep what_to_keep(const std::vector<std::string>& changed, const Scenario& next,
                      const BackendDecision& backend) const;
    void rebuild(Scenario next, std::vector<std::string> overrides, const std::vector<std::string>& changed);
    Built build(Scenario next, BackendDecision backend, Keep keep) const;
    void build_light(Built& built) const;
    void replace(Built next, Keep kept);
    void show_run(Built& run, Snapshot& to, bool estimates);
    void disturb(std::span<const Disturbance> disturbances);

    DeviceWish device_;
    Edits edits_;
    Built run_;
    std::array<bool, 3> is_on_{true, true, true};
    std::optional<BeamView> view_;
    std::optional<HeldSphere> sphere_;
    Snapshot trial_;               ///< the first frame of what was built last
    bool is_trial_shown_ = false;  ///< it is of the present moment
    ErrorEstimates estimates_;
    double waves_ms_ = 0;  ///< of the advance() that led here
    bool failed_ = false;
    std::string note_;
};

}  // namespace waterlight
