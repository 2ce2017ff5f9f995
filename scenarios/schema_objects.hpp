// The keys of what light meets beside water: objects, lamps, and the methods that follow it there.
#pragma once

#include "scenarios/scenario.hpp"
#include "scenarios/schema.hpp"

namespace waterlight {

/// [[object]]
void describe_objects(Visitor& v, std::vector<ObjectSection>& objects);
/// Of [light]: its type, and what a lamp has.
void describe_lamp(Visitor& v, std::optional<Lamp>& lamp);
/// Of [caustics.floor]: [caustics.floor.splat] and [caustics.floor.photons].
void describe_methods(Visitor& v, FloorSection& s);

}  // namespace waterlight
