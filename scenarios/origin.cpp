#include "scenarios/origin.hpp"

#include <fmt/format.h>

#include "sim/message.hpp"

namespace waterlight {

void reject(std::string_view place, std::string_view key, std::string_view found, std::string_view allowed,
            std::string_view nearest) {
    std::string message =
        fmt::format("{}: {}: found {}; allowed: {}", place, shortened(key), shortened(found), allowed);
    if (!nearest.empty()) message += fmt::format("; did you mean \"{}\"?", nearest);
    throw InputError(in_one_line(message));
}

std::string Origin::place(std::string_view key) const {
    while (!key.empty()) {
        if (const auto stated = places.find(key); stated != places.end()) return stated->second;
        const std::size_t end = key.find_last_of(".[");
        key = key.substr(0, end == std::string_view::npos ? 0 : end);
    }
    return file.string();
}

void Origin::reject(std::string_view key, std::string_view found, std::string_view allowed) const {
    waterlight::reject(place(key), key, found, allowed);
}

void Origin::reject(std::string_view key, const InputError& what) const {
    throw InputError(fmt::format("{}: {}: {}", place(key), key, what.what()));
}

}  // namespace waterlight
