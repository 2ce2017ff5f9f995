// The report of a run.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace waterlight {

/// Writes `json` indented, whole or not at all. A number that is not finite becomes null; bytes that are not UTF-8
/// become U+FFFD. Throws WorldError.
void write_json(const std::filesystem::path& path, const nlohmann::json& json);
/// The same, keys in the order of insertion.
void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& json);

}  // namespace waterlight
