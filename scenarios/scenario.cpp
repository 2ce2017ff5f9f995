#include "scenarios/scenario.hpp"

#include <algorithm>

namespace waterlight {

std::string_view name_of(FloorMethod method) {
    switch (method) {
        case FloorMethod::two_pass:
            return "two-pass";
        case FloorMethod::truth:
            return "truth";
        case FloorMethod::quads:
            return "quads";
        case FloorMethod::splat:
            return "splat";
        case FloorMethod::photons:
            return "photons";
    }
    return "";
}

bool OutputSection::wants(const std::string& format) const {
    return std::find(formats.begin(), formats.end(), format) != formats.end();
}

bool OutputSection::shows(const std::string& field) const {
    return std::find(fields.begin(), fields.end(), field) != fields.end();
}

}  // namespace waterlight
