#include "scenarios/scenario.hpp"

#include <algorithm>

namespace waterlight {

std::string_view name_of(FloorMethod method) { return floor_method_names[static_cast<std::size_t>(method)]; }

bool OutputSection::wants(const std::string& format) const {
    return std::find(formats.begin(), formats.end(), format) != formats.end();
}

bool OutputSection::shows(const std::string& field) const {
    return std::find(fields.begin(), fields.end(), field) != fields.end();
}

}  // namespace waterlight
