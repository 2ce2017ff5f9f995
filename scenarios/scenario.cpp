#include "scenarios/scenario.hpp"

#include <algorithm>

namespace waterlight {

bool OutputSection::wants(const std::string& format) const {
    return std::find(formats.begin(), formats.end(), format) != formats.end();
}

bool OutputSection::shows(const std::string& field) const {
    return std::find(fields.begin(), fields.end(), field) != fields.end();
}

}  // namespace waterlight
