// What all that follows photons asks of its settings.
#pragma once

#include "caustics/photons/photons.hpp"

namespace waterlight {

/// Throws InputError where a setting is out of its range.
void validate(const PhotonSettings& settings);

/// Whether there is any light.
bool is_lit(const PhotonSettings& settings);

inline std::int64_t photons_of_pass(const PhotonOptions& options) {
    return static_cast<std::int64_t>(options.map) * options.map;
}

}  // namespace waterlight
