// The shallow-water model's benchmark, the same for every back-end.
#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <memory>
#include <string>

#include "sim/shallow_water.hpp"

namespace waterlight::bench {

using MakeShallow = std::function<std::unique_ptr<ShallowWaterModel>(const ShallowWaterSettings&)>;

/// Registers waves_shallow_water/BACKEND/CELLS/wet and .../shore for grids of 512, 1024 and 2048 cells squared, timed
/// over `frames` frames of four or five steps where that is above 0, else as long as the framework takes.
void register_shallow(const std::string& backend, const MakeShallow& make, int frames = 0);

}  // namespace waterlight::bench
