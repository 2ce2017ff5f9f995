#include "app/view/edits.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "export/atomic_file.hpp"
#include "scenarios/reader.hpp"
#include "scenarios/rewrite.hpp"

namespace waterlight {

namespace {

bool is_within(const std::string& key, const std::string& section) {
    return key.starts_with(section + ".") || key.starts_with(section + "[");
}

/// The source [[waves.source]] number `n` that is this drop.
std::string source_text(std::size_t n, const Drop& d) {
    return fmt::format(
        "waves.source[{}]={{type = \"drop\", at_m = [{:.17g}, {:.17g}], radius_m = {:.17g}, height_m = {:.17g}, "
        "time_s = {:.17g}}}",
        n, d.at_m.x, d.at_m.y, d.radius_m, d.height_m, d.time_s);
}

}  // namespace

std::vector<std::string> Edits::with(const std::vector<std::string>& more) const {
    std::vector<std::string> all = overrides();
    for (const std::string& override : more) {
        const bool takes_back = override.find('=') == std::string::npos;
        std::erase_if(all, [&](const std::string& other) {
            return key_of(other) == key_of(override) || (takes_back && is_within(key_of(other), override));
        });
        if (!takes_back) all.push_back(override);
    }
    return all;
}

std::string Edits::text_with(const Scenario& scenario, const std::vector<std::string>& more) const {
    std::vector<std::string> all = with(more);
    std::size_t n = scenario.waves.sources.size();
    for (const Drop& drop : drops_) all.push_back(source_text(n++, drop));
    return rewritten(origin_.text, all);
}

void Edits::save(const Scenario& scenario, const std::filesystem::path& file) const {
    const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
    write_file(file, text_with(scenario, data_overrides(scenario, folder)));
}

}  // namespace waterlight
