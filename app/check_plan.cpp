#include "app/check_plan.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <fstream>

#include "app/bytes_of.hpp"
#include "app/floor_stage.hpp"
#include "scenarios/build.hpp"
#include "scenarios/memory.hpp"
#include "scenarios/reader.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

namespace fs = std::filesystem;

/// Whether a line of the file states a check. Malformed TOML may: it is then reported, not passed over.
bool states_checks(const fs::path& file) {
    std::ifstream text(file);
    for (std::string line; std::getline(text, line);) {
        std::erase_if(line, [](char c) { return c == ' ' || c == '\t'; });
        if (line.starts_with("[[check]]") || line.starts_with("check=")) return true;
    }
    return false;
}

void add_folder(const fs::path& folder, std::vector<fs::path>& files) {
    std::error_code error;
    std::vector<fs::path> found;
    for (auto entry = fs::recursive_directory_iterator(folder, error); !error && entry != fs::end(entry);
         entry.increment(error))
        if (entry->path().extension() == ".toml" && states_checks(entry->path()))
            found.push_back(entry->path().lexically_normal());
    if (error) throw WorldError(fmt::format("cannot read {}: {}", folder.string(), error.message()));
    std::sort(found.begin(), found.end());
    files.insert(files.end(), found.begin(), found.end());
}

std::vector<fs::path> scenario_files(const std::vector<fs::path>& paths) {
    std::vector<fs::path> files;
    for (const fs::path& path : paths) {
        std::error_code ignored;
        if (fs::is_directory(path, ignored)) {
            add_folder(path, files);
            continue;
        }
        if (!fs::is_regular_file(path, ignored))
            reject(path.string(), "check", "no file that can be read", "scenarios (.toml), or folders that hold them");
        // Where nothing looks like a check, a malformed text still is what is wrong.
        if (!states_checks(path) && parse_scenario(bytes_of(path), path, {}).checks.empty())
            reject(path.string(), "check", "no [[check]]", "a scenario with [[check]] entries");
        files.push_back(path);
    }
    std::vector<fs::path> once;
    for (const fs::path& file : files)
        if (std::find(once.begin(), once.end(), file) == once.end()) once.push_back(file);
    return once;
}

/// Why the scenario cannot run where --backend wants it; else empty.
std::string cannot_run(const Scenario& scenario, const std::string& backend) {
    if (backend != "vulkan") return {};
    if (scenario.floor && !has_vulkan_method(scenario.floor->method))
        return fmt::format("method {} is computed on the CPU only, not by --backend vulkan",
                           name_of(scenario.floor->method));
    if (!gpu::survey().chosen) return "no Vulkan device";
    return {};
}

/// The scenario at every resolution that its checks ask for fits too: what is wrong shows before anything is run.
double memory_of(const CheckItem& item) {
    double most = estimate_memory(*item.scenario).total();
    for (const Check& check : item.scenario->checks) {
        if (check.is_against_scenario())
            most = std::max(most, estimate_memory(read_scenario(*check.reference, {"check=[]"})).total());
        for (const Resolution& value : check.order ? check.order->values : std::vector<Resolution>{}) {
            std::vector<std::string> overrides = item.overrides;
            overrides.push_back(fmt::format("{}={}", check.order->key, value.text));
            most = std::max(most, estimate_memory(read_scenario(item.file, overrides)).total());
        }
    }
    return most;
}

CheckItem read_item(const fs::path& file, const CheckOptions& options) {
    CheckItem item;
    item.file = file;
    item.name = file.stem().string();
    try {
        item.overrides = parse_scenario(bytes_of(file), file, {}).check_run.set;
        if (options.out.empty())
            item.overrides.insert(item.overrides.begin(), {"output.formats=[]", "output.image=false"});
        item.overrides.insert(item.overrides.end(), options.overrides.begin(), options.overrides.end());
        item.scenario = read_scenario(file, item.overrides);
        item.memory_bytes = memory_of(item);
        item.skipped = cannot_run(*item.scenario, options.backend);
    } catch (const MissingData& error) {
        item.skipped = error.what();
    } catch (const InputError& error) {
        item.wrong = error.what();
    }
    if (!item.wrong.empty() || !item.skipped.empty()) item.scenario.reset();
    return item;
}

}  // namespace

std::string full_name(const CheckItem& item, const std::string& quantity) {
    return fmt::format("{}/{}", item.name, quantity);
}

std::vector<CheckItem> plan_checks(const CheckOptions& options) {
    const auto matches = [&](const std::string& name) { return fnmatch(options.filter.c_str(), name.c_str(), 0) == 0; };
    std::vector<CheckItem> items;
    for (const fs::path& file : scenario_files(options.paths)) {
        CheckItem item = read_item(file, options);
        const int checks = item.scenario ? static_cast<int>(item.scenario->checks.size()) : 0;
        for (int i = 0; i < checks; ++i)
            if (matches(full_name(item, item.scenario->checks[static_cast<std::size_t>(i)].quantity)))
                item.chosen.push_back(i);
        // Of a scenario that cannot be read the checks are not known: its name decides.
        const bool may_match = !item.scenario && (options.filter.starts_with(item.name) || matches(item.name + "/"));
        if (!item.chosen.empty() || may_match) items.push_back(std::move(item));
    }
    if (items.empty())
        reject("command line", options.filter == "*" ? "PATH" : "--filter",
               options.filter == "*" ? "no scenario with a [[check]]" : fmt::format("\"{}\"", options.filter),
               "what leads to at least one check, as SCENARIO/QUANTITY");
    return items;
}

}  // namespace waterlight
