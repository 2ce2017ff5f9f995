// The floor map's benchmark, the same for every back-end.
#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <memory>
#include <string>

#include "caustics/floor.hpp"
#include "caustics/splat/splat.hpp"

namespace waterlight::bench {

using MakeMapper = std::function<std::unique_ptr<FloorMapper>(const FloorSettings&)>;

struct FloorCase {
    int width;
    int height;
    int window;
};

/// The moving pool that every method of the floor map is timed on, and what its map is asked for.
struct FloorScene {
    Surface surface;
    FloorSettings settings;
};
FloorScene floor_scene(const FloorCase& c);

/// Sets the counters lost_percent, rmse_percent (relative, against the truth, over 96 by 96 pixels in the middle) and
/// pixels_per_s.
void count(benchmark::State& state, const FloorScene& scene, const FloorMap& map);

/// Registers floor_two_pass/BACKEND/... and floor_two_pass_adaptive/BACKEND/... for the three sizes.
void register_floor(const std::string& backend, const MakeMapper& make);

/// Registers floor_quads/cpu/... for the same sizes.
void register_floor_quads();

/// Registers floor_photons/...
void register_floor_photons();

using MakeSplats = std::function<std::unique_ptr<SplatFloor>(const SplatSettings&)>;

/// Registers floor_splat/BACKEND/...
void register_floor_splat(const std::string& backend, const MakeSplats& make);

}  // namespace waterlight::bench
