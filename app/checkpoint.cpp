#include "app/checkpoint.hpp"

#include <fmt/format.h>

#include "app/report.hpp"
#include "app/version.hpp"
#include "scenarios/reader.hpp"
#include "sim/error.hpp"
#include "sim/file_stamp.hpp"

namespace waterlight {

RunIdentity identity_of(const Scenario& scenario, const BackendDecision& backend, const std::string& picture_device) {
    RunIdentity identity{version, hash_of(scenario.origin), backend.device, ""};
    identity.device += backend.backend == Backend::vulkan ? " by Vulkan" : " by itself";
    if (!picture_device.empty()) identity.device += ", pictures by " + picture_device;
    for (const std::filesystem::path& file : data_files(scenario)) {
        const FileStamp stamp = stamp_of(file);
        identity.files += fmt::format("{} {} {}\n", file.string(), stamp.bytes, stamp.changed_ns);
    }
    return identity;
}

void exchange_identity(StateArchive& state, RunIdentity present, const std::filesystem::path& checkpoint) {
    const auto exchange = [&](std::string& now, const char* what) {
        std::string then = now;
        state.text(then);
        if (then == now) return;
        throw InputError(fmt::format(
            "--resume: {} is of another run: {} differs; without --resume the run starts from the beginning",
            checkpoint.string(), what));
    };
    exchange(present.version, "the version of the program");
    exchange(present.scenario, "the scenario or one of its --set");
    exchange(present.device, "the back-end or its device");
    exchange(present.files, "a data file");
}

}  // namespace waterlight
