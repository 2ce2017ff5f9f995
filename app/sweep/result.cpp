#include "app/sweep/result.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "export/report.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

using Json = nlohmann::ordered_json;

/// JSON has no number that is not finite: write_json() makes it null.
double number(const Json& json) { return json.is_null() ? std::nan("") : json.get<double>(); }

}  // namespace

void write_result(const std::filesystem::path& path, const SettingResult& r) {
    const Json json{{"overrides", r.overrides},
                    {"wall_s", {{"waves", r.wall_s.waves}, {"caustics.floor", r.wall_s.floor}}},
                    {"errors", {{"waves", r.errors.waves}, {"light", r.errors.light}, {"together", r.errors.both}}},
                    {"frames", r.frames},
                    {"backend", r.backend},
                    {"device", r.device},
                    {"threads", r.threads},
                    {"reference", r.reference},
                    {"failed", r.failed}};
    write_json(path, json);
}

std::optional<SettingResult> read_result(const std::filesystem::path& path) {
    std::ifstream file(path);
    if (!file) return std::nullopt;
    try {
        const Json json = Json::parse(file);
        SettingResult r;
        r.overrides = json.at("overrides").get<std::vector<std::string>>();
        r.wall_s = {json.at("wall_s").at("waves").get<double>(), json.at("wall_s").at("caustics.floor").get<double>()};
        const Json& errors = json.at("errors");
        r.errors = {number(errors.at("waves")), number(errors.at("light")), number(errors.at("together"))};
        r.frames = json.at("frames").get<int>();
        r.backend = json.at("backend").get<std::string>();
        r.device = json.at("device").get<std::string>();
        r.threads = json.at("threads").get<int>();
        r.reference = json.at("reference").get<std::string>();
        r.failed = json.at("failed").get<std::string>();
        return r;
    } catch (const nlohmann::json::exception&) {
        throw WorldError(fmt::format("{} is no result of a sweep; remove it, or start with --fresh", path.string()));
    }
}

}  // namespace waterlight
