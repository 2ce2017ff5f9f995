// The floor map's benchmark, the same for every back-end.
#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <memory>
#include <string>

#include "caustics/floor.hpp"

namespace waterlight::bench {

using MakeMapper = std::function<std::unique_ptr<FloorMapper>(const FloorSettings&)>;

struct FloorCase {
    int width;
    int height;
    int window;
};

/// Registers floor_two_pass/BACKEND/... and floor_two_pass_adaptive/BACKEND/... for the three sizes.
void register_floor(const std::string& backend, const MakeMapper& make);

}  // namespace waterlight::bench
