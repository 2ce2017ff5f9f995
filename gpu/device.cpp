#include "gpu/device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <tuple>

namespace waterlight::gpu {

namespace {

constexpr Version needed_api{1, 3, 0};
constexpr std::uint64_t needed_storage_buffer_b = std::uint64_t{1} << 27;  // what Vulkan itself requires
constexpr std::uint32_t needed_texels = needed_storage_buffer_b / 4;       // such a buffer of single numbers

std::vector<std::string> rejections(const DeviceDescription& device) {
    std::vector<std::string> reasons;
    if (device.api < needed_api)
        reasons.push_back(fmt::format("offers Vulkan {}, needs {}", to_string(device.api), to_string(needed_api)));
    if (!device.compute) reasons.emplace_back("has no queue for compute passes");
    if (device.largest_storage_buffer_b < needed_storage_buffer_b)
        reasons.push_back(fmt::format("holds storage buffers of {} bytes, needs {}", device.largest_storage_buffer_b,
                                      needed_storage_buffer_b));
    if (device.most_texels < needed_texels)
        reasons.push_back(fmt::format("reads {} texels of a buffer, needs {}", device.most_texels, needed_texels));
    if (!device.presents) return reasons;
    for (std::string& reason : drawing_rejections(device)) reasons.push_back(std::move(reason));
    if (!*device.presents) reasons.emplace_back("cannot show pictures in this window system");
    return reasons;
}

std::string lower(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return result;
}

std::optional<std::size_t> as_index(std::string_view text) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return index;
}

std::string list(const std::vector<Candidate>& candidates) {
    std::string text;
    for (std::size_t i = 0; i < candidates.size(); ++i)
        text += fmt::format("{}{} \"{}\" ({})", i == 0 ? "" : ", ", i, candidates[i].device.name,
                            name(candidates[i].device.type));
    return text;
}

bool matches(const std::vector<Candidate>& candidates, std::size_t i, std::string_view wanted) {
    if (wanted.empty()) return true;
    if (const auto index = as_index(wanted)) return *index == i;
    return lower(candidates[i].device.name).find(lower(wanted)) != std::string::npos;
}

// One line for the case that nothing can be chosen; `matching` are the candidates that the user's wish admits.
std::string explain_none(const std::vector<Candidate>& candidates, const std::vector<std::size_t>& matching,
                         std::string_view wanted) {
    if (candidates.empty()) return "no Vulkan device was found";
    if (matching.empty()) return fmt::format("no Vulkan device is \"{}\"; there are: {}", wanted, list(candidates));
    std::string text = "no Vulkan device can be used: ";
    for (const std::size_t i : matching)
        text += fmt::format("{}{} \"{}\" {}", i == matching.front() ? "" : "; ", i, candidates[i].device.name,
                            fmt::join(candidates[i].rejections, " and "));
    return text;
}

}  // namespace

std::vector<std::string> drawing_rejections(const DeviceDescription& device) {
    std::vector<std::string> reasons;
    if (!device.graphics) reasons.emplace_back("has no queue for drawing");
    if (!device.adds_floats) reasons.emplace_back("does not blend into targets of 32-bit floats");
    return reasons;
}

std::string_view name(DeviceType type) {
    switch (type) {
        case DeviceType::discrete:
            return "discrete GPU";
        case DeviceType::integrated:
            return "integrated GPU";
        case DeviceType::virtual_gpu:
            return "virtual GPU";
        case DeviceType::cpu:
            return "CPU";
        case DeviceType::other:
            break;
    }
    return "other";
}

bool Version::operator<(const Version& other) const {
    return std::tie(major_number, minor_number, patch_number) <
           std::tie(other.major_number, other.minor_number, other.patch_number);
}

std::string to_string(const Version& version) {
    return fmt::format("{}.{}.{}", version.major_number, version.minor_number, version.patch_number);
}

Selection select_device(std::vector<DeviceDescription> devices, std::string_view wanted) {
    Selection selection;
    for (DeviceDescription& device : devices) {
        std::vector<std::string> reasons = rejections(device);
        selection.candidates.push_back({std::move(device), std::move(reasons)});
    }
    const std::vector<Candidate>& candidates = selection.candidates;

    std::vector<std::size_t> matching;
    for (std::size_t i = 0; i < candidates.size(); ++i)
        if (matches(candidates, i, wanted)) matching.push_back(i);

    // The types are declared in the order of preference; among equals the loader's order stands.
    for (const std::size_t i : matching) {
        if (!candidates[i].usable()) continue;
        if (!selection.chosen || candidates[i].device.type < candidates[*selection.chosen].device.type)
            selection.chosen = i;
    }

    if (!selection.chosen) {
        selection.explanation = explain_none(candidates, matching, wanted);
        return selection;
    }
    const DeviceDescription& chosen = candidates[*selection.chosen].device;
    selection.explanation =
        wanted.empty()
            ? fmt::format("\"{}\": {}, the best of {} found", chosen.name, name(chosen.type), candidates.size())
            : fmt::format("\"{}\": {}, asked for as \"{}\"", chosen.name, name(chosen.type), wanted);
    return selection;
}

bool has_real_gpu(const Selection& selection) {
    return std::any_of(selection.candidates.begin(), selection.candidates.end(), [](const Candidate& candidate) {
        const DeviceType type = candidate.device.type;
        return candidate.usable() &&
               (type == DeviceType::discrete || type == DeviceType::integrated || type == DeviceType::virtual_gpu);
    });
}

}  // namespace waterlight::gpu
