// The keys that only the model shallow-water has, and those of the sides.
#pragma once

#include "scenarios/scenario.hpp"
#include "scenarios/schema.hpp"

namespace waterlight::schema {

/// The keys of domain.
void describe_ground(Visitor& v, DomainSection& s);

/// Of waves.boundary.
inline const Key sides_key{
    "boundary", "",
    "What happens at the sides; auto is periodic for the model prescribed and for a spectrum or a buoy, else wall. "
    "inflow, and sides that differ from their opposite, with the model shallow-water only. Light sees a wall at both "
    "sides of an axis that has one, a piston being one too; elsewhere still water beyond absorbing and inflow sides."};

void describe_sides(Visitor& v, WavesSection& s);

void describe_initial(Visitor& v, std::vector<ShallowInitial>& s);

/// The keys of waves.
void describe_shallow(Visitor& v, WavesSection& s);

}  // namespace waterlight::schema
