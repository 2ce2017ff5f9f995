#include "app/devices.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <omp.h>

#include "app/floor_stage.hpp"
#include "gpu/device.hpp"

namespace waterlight {

std::string devices_text() {
    const gpu::Selection selection = gpu::survey();
    std::string text = fmt::format("cpu     {} ({} threads)\n", processor_name(), omp_get_max_threads());
    for (std::size_t i = 0; i < selection.candidates.size(); ++i) {
        const gpu::Candidate& candidate = selection.candidates[i];
        const gpu::DeviceDescription& d = candidate.device;
        text += fmt::format("vulkan  {}: {} ({}, {}, Vulkan {}, {} MiB)\n", i, d.name, gpu::name(d.type), d.driver,
                            gpu::to_string(d.api), d.memory_b >> 20);
        if (!candidate.usable())
            text += fmt::format("        cannot be used: {}\n", fmt::join(candidate.rejections, "; "));
    }
    text += fmt::format("Of the Vulkan devices: {}\n", selection.explanation);
    text += gpu::has_real_gpu(selection) ? "--backend auto takes vulkan: there is a GPU\n"
                                         : "--backend auto takes cpu: no Vulkan device is a GPU\n";
    return text;
}

}  // namespace waterlight
