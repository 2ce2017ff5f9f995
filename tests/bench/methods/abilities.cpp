// What each method can do, and which to choose.
#include <fmt/format.h>

#include "tests/bench/methods/report.hpp"

namespace waterlight::methods {

void report_abilities() {
    fmt::print(R"(
## What each can do

TODO
)");
}

}  // namespace waterlight::methods
