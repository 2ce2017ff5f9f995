// What two runs left behind, compared.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/scenarios/program.hpp"

namespace waterlight::test {

/// Every file of a folder by its path within it; of report.json what does not depend on how long it took and by how
/// many threads.
inline std::map<std::string, std::string> files_of(const std::filesystem::path& folder) {
    namespace fs = std::filesystem;
    std::map<std::string, std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        // The lock of a run that was killed stays.
        if (!entry.is_regular_file() || entry.path().filename() == ".waterlight.lock") continue;
        std::string& text = files[entry.path().lexically_relative(folder).string()];
        text = read_file(entry.path());
        if (entry.path().filename() != "report.json") continue;
        nlohmann::ordered_json report = nlohmann::ordered_json::parse(text);
        report.erase("wall_s");
        report["device"].erase("threads");
        text = report.dump(1);
    }
    return files;
}

/// The names of files that differ or are in one of both only; empty where there are none.
inline std::string differences(const std::map<std::string, std::string>& a,
                               const std::map<std::string, std::string>& b) {
    std::string names;
    for (const auto& [name, text] : a)
        if (const auto other = b.find(name); other == b.end() || other->second != text) names += name + '\n';
    for (const auto& [name, text] : b)
        if (!a.contains(name)) names += name + '\n';
    return names;
}

}  // namespace waterlight::test
