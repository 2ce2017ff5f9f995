// Where a run computes, and why; and the part of it that turns surfaces into floor maps.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/method_record.hpp"
#include "caustics/beam_renderer.hpp"
#include "caustics/light_ledger.hpp"
#include "caustics/spectral_floor.hpp"
#include "gpu/context.hpp"
#include "scenarios/build.hpp"

namespace waterlight {

enum class Backend { automatic, cpu, vulkan };

/// What the command line says about where to compute.
struct DeviceWish {
    Backend backend = Backend::automatic;
    std::string device;       ///< name or index of a Vulkan device; empty for the best
    bool validation = false;  ///< switch the Vulkan validation layer on
};

/// A back-end that was chosen, and why.
struct BackendDecision {
    Backend backend = Backend::cpu;  ///< never automatic
    std::string device;              ///< name of the device
    std::string reason;
    std::shared_ptr<gpu::Context> context;  ///< where it is vulkan
};

/// Of the floor map, light in the water and the shallow-water model. automatic takes vulkan where one of them is there
/// and a GPU is too, or a device is named, else cpu: a CPU that plays a GPU is slower than the CPU itself. Throws
/// InputError where the wish contradicts itself or the scenario, gpu::Error where there is no device.
BackendDecision choose_backend(const DeviceWish& wish, const Scenario& scenario);

/// A floor mapper that can say how wrong it is.
class FloorStage {
  public:
    virtual ~FloorStage() = default;
    virtual void compute(const Surface& surface, FloorMap& map) = 0;
    /// What the method says of the last map.
    virtual MethodRecord record(const FloorMap& map) const = 0;
    /// Irradiance (W/m2) at a place on the floor of the map just computed from `surface`: of the pixel that holds it,
    /// by the truth of the place itself; NaN beyond the map.
    virtual double irradiance_at(const Surface& surface, const FloorMap& map, glm::dvec2 at_m) const = 0;
    /// Where the light of the last map went.
    virtual LightLedger ledger(const FloorMap& map) const = 0;
    /// Where light is in colour, the map of each wavelength; else none.
    virtual std::span<const BandMap> bands() const { return {}; }
};

/// `model` must outlive the result: the truth of a formula is computed from the formula.
std::unique_ptr<FloorStage> make_floor_stage(const Scenario& scenario, const BuiltModel& model,
                                             const BackendDecision& decision);

/// Pictures and fields of light in the water.
std::unique_ptr<BeamRenderer> make_beam_renderer(const BackendDecision& decision);

/// The name of this machine's processor.
std::string processor_name();

}  // namespace waterlight
