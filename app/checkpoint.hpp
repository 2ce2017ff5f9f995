// Which run a checkpoint belongs to: going on with another would give numbers that belong to neither.
#pragma once

#include <filesystem>
#include <string>

#include "app/floor_stage.hpp"
#include "scenarios/scenario.hpp"
#include "sim/state_archive.hpp"

namespace waterlight {

/// What must be the same for a run to go on bit by bit.
struct RunIdentity {
    std::string version;   ///< of the program
    std::string scenario;  ///< hash of its text and overrides
    std::string device;    ///< back-end and device, and the device that draws the scene
    std::string files;     ///< sizes and times of the data files
};

/// `picture_device` draws the scene; empty where none does.
RunIdentity identity_of(const Scenario& scenario, const BackendDecision& backend, const std::string& picture_device);

/// Gives the identity to the archive; or takes it from there and throws InputError, naming the `checkpoint` and what
/// differs, where it is not `present`.
void exchange_identity(StateArchive& state, RunIdentity present, const std::filesystem::path& checkpoint);

}  // namespace waterlight
