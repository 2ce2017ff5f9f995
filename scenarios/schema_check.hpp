// What a scenario expects of itself: the [[check]] part of the schema.
#pragma once

#include "scenarios/scenario.hpp"
#include "scenarios/schema.hpp"

namespace waterlight::schema {

void describe_check(Visitor& v, Check& s);
void describe_check_run(Visitor& v, CheckRunSection& s);

}  // namespace waterlight::schema
