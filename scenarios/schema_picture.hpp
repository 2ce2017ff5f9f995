// The keys of pictures of the scene.
#pragma once

#include "scenarios/scenario.hpp"
#include "scenarios/schema.hpp"

namespace waterlight {

/// Of [picture].
void describe_picture(Visitor& v, PictureSection& s);

}  // namespace waterlight
