#include "export/report.hpp"

#include <nlohmann/json.hpp>

#include "export/atomic_file.hpp"

namespace waterlight {

namespace {

template <class Json>
void write(const std::filesystem::path& path, const Json& json) {
    write_file(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
}

}  // namespace

void write_json(const std::filesystem::path& path, const nlohmann::json& json) { write(path, json); }
void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& json) { write(path, json); }

}  // namespace waterlight
