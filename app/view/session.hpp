// A running scenario to play with: `view` without its window. A thread of its own advances the water in real time and
// lights it; whoever draws takes the latest snapshot and sends commands, and neither ever waits for the other.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/view/snapshot.hpp"
#include "app/view/water_light.hpp"

namespace waterlight {

struct SessionSettings {
    double frame_s = 1.0 / 30;  ///< wall time between frames while it plays, > 0; a single step takes frame_s * speed
    bool plays = true;          ///< from the start; else it waits for play() or step()
    /// Frames between two estimates of the error while it plays, >= 1, where the scenario asks for them; single steps
    /// are all estimated.
    int estimate_every = 10;
};

struct SessionStatus {
    bool plays = false;
    bool is_building = false;  ///< new settings are being built; the snapshot is still of the old ones
    double speed = 1;          ///< simulated seconds a second that were asked for
    double rate = 0;           ///< and that came, over the last second or the last frame if that took longer; 0 at rest
    std::uint64_t command = 0;  ///< the last command that was applied or refused
    /// Of the last command that was refused: one line, as an InputError has it; empty before. What ran goes on.
    std::string refusal;
    std::uint64_t refused = 0;  ///< the number of that command; 0 before
    /// What happened to the water at the last change of settings: empty where it was kept, else one line that says why
    /// it started again.
    std::string note;
    /// Why the run has ended: one line. Empty while it is well. After that every command is refused but reset() and
    /// set() of what builds the run anew.
    std::string failure;
};

/// All functions may be called from any thread. A command returns at once: it is applied between two frames, after
/// those sent before it, and the snapshots from then on have its number in `command` or a larger one. What cannot be
/// done is refused in SessionStatus; nothing is thrown but by the constructor, by save() and by text().
class Session {
  public:
    using Ticket = std::uint64_t;  ///< the number of a command, from 1

    /// Builds the scenario and waits for its first snapshot, of time 0. Throws InputError, WorldError or gpu::Error as
    /// `run` does where that fails. A Vulkan device is the session's own: others open theirs.
    Session(const Scenario& scenario, const DeviceWish& device, const SessionSettings& settings = {});
    /// Ends after the frame at hand. Snapshots outlive it.
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// Never null. Takes microseconds whatever the solver does; its `number` tells whether it is new.
    std::shared_ptr<const Snapshot> latest() const;
    /// Takes microseconds.
    SessionStatus status() const;
    /// Returns when that command has been applied or refused, and is shown: for tests and scripts.
    void await(Ticket command) const;

    Ticket play();
    Ticket pause();
    /// One frame of frame_s * speed simulated seconds, whatever it takes; pauses.
    Ticket step();
    /// Starts again at time 0 with the settings as they are; drops made by hand are forgotten.
    Ticket reset();
    /// Simulated seconds per wall second, in [0.001, 100].
    Ticket speed(double simulated_per_wall);

    /// A drop falls now: radius and height in m, height < 0 digs. Refused where the surface is prescribed.
    Ticket drop(glm::dvec2 at_m, double radius_m, double height_m);
    /// A sphere is there, as if it had always been; one that is held is let go before.
    Ticket hold_sphere(const HeldSphere& sphere);
    /// The sphere moves and pushes the water: see sphere_pushes(). Refused where none is held or the surface is
    /// prescribed.
    Ticket move_sphere(glm::dvec3 centre_m);
    /// It is gone without a trace.
    Ticket release_sphere();
    /// From now on it rains so many drops a square metre and second, or not: the scenario's own rain included, whose
    /// radii and heights hold; > 0. Refused where the surface is prescribed.
    Ticket rain(std::optional<double> drops_per_m2_s);

    /// Degrees, as light.elevation_deg and light.azimuth_deg. The water goes on.
    Ticket sun(double elevation_deg, double azimuth_deg);
    /// Where the scattered light is seen from; none: nowhere. At the start it is the scenario's camera.
    Ticket look(const std::optional<BeamView>& view);
    /// Computes it from now on, or leaves it out. A section of the settings that is not there is added with its
    /// defaults; one that is left out stays.
    Ticket compute(LightPart part, bool on);
    /// Lays "key=value" over the settings, as --set does: "waves.model=linear", "domain.cells=[256,192]",
    /// "caustics.floor.footprint=pixel", "caustics.beams.grid=[64,64]", "accuracy.estimate=true"; a key alone takes
    /// back what was laid over it. All of them or none. The water goes on where the new model can take its state: same
    /// model, cells, sides and back-end; else it starts again, and the status has a note.
    Ticket set(std::vector<std::string> overrides);
    /// As --backend and --device. Only a shallow-water model starts again.
    Ticket set_device(const DeviceWish& device);

    /// The settings as they are now as a scenario: the text it began with, changed where it was changed, drops made by
    /// hand as sources at their times. What commands that are still waiting will do is not in it.
    std::string text() const;
    /// The same to a file that read_scenario() reads, wherever it lies: it appears whole or not at all. Throws
    /// WorldError where it cannot be written.
    void save(const std::filesystem::path& file) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace waterlight
