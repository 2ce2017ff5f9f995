// The choice of a device, with reasons: a pure function on plain descriptions, so that it can be tested without a GPU.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace waterlight::gpu {

enum class DeviceType { discrete, integrated, virtual_gpu, cpu, other };

/// "discrete GPU", "CPU" and so on.
std::string_view name(DeviceType type);

/// A Vulkan version; to_string() gives "1.3.230".
struct Version {
    std::uint32_t major_number = 0;
    std::uint32_t minor_number = 0;
    std::uint32_t patch_number = 0;
    bool operator<(const Version& other) const;
};
std::string to_string(const Version& version);

/// What a physical device says about itself.
struct DeviceDescription {
    std::string name;
    DeviceType type = DeviceType::other;
    std::string driver;  ///< name and version of the driver
    Version api;
    bool compute = false;                        ///< some queue of it runs compute passes
    std::uint64_t largest_storage_buffer_b = 0;  ///< bytes
    std::uint32_t most_texels = 0;               ///< of a buffer that is read as texels
    std::uint64_t memory_b = 0;                  ///< bytes of device-local memory
    bool graphics = false;                       ///< the queue that runs compute passes draws too
    bool adds_floats = false;                    ///< blends into targets of 32-bit floats
    std::uint32_t largest_target = 0;            ///< pixels along a side of what it draws into
    std::optional<bool> presents = {};           ///< that queue shows pictures in the window asked for; none: none was
};

/// Every reason why passes that draw cannot run on the device; none if they can. Other passes may. A device for a
/// window is rejected for them, too.
std::vector<std::string> drawing_rejections(const DeviceDescription& device);

/// A device and every reason why it cannot be used; none if it can.
struct Candidate {
    DeviceDescription device;
    std::vector<std::string> rejections;

    bool usable() const { return rejections.empty(); }
};

struct Selection {
    std::vector<Candidate> candidates;  ///< in the order of the loader; the index is the number a user may ask for
    std::optional<std::size_t> chosen;  ///< index into candidates
    std::string explanation;            ///< one line: why this one, or why none
};

/// Chooses among `devices`. `wanted` is empty (the best: discrete before integrated before virtual before CPU, then the
/// first), an index, or a part of a name in any case. Never throws: where nothing fits, `chosen` is empty and
/// `explanation` says why.
Selection select_device(std::vector<DeviceDescription> devices, std::string_view wanted = {});

/// True where a usable candidate is a GPU and not a program that plays one on the CPU.
bool has_real_gpu(const Selection& selection);

/// Asks the Vulkan loader for its devices and chooses. Without a loader or a driver it gives no candidates, and an
/// explanation that names what to install.
Selection survey(std::string_view wanted = {});

}  // namespace waterlight::gpu
