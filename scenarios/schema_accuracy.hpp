// The keys of [accuracy].
#pragma once

#include "scenarios/scenario.hpp"
#include "scenarios/schema.hpp"

namespace waterlight {

void describe_accuracy(Visitor& v, AccuracySection& s);

}  // namespace waterlight
