#include "app/ground_heights.hpp"

#include <algorithm>

#include "app/shallow_watch.hpp"
#include "scenarios/build_shallow.hpp"
#include "scenarios/combinations.hpp"
#include "scenarios/resolve.hpp"

namespace waterlight {

Field<float> ground_heights(const Scenario& scenario, const BuiltModel& model) {
    const Grid grid = grid_of(scenario);
    if (model.shallow) return bed_of(*model.shallow, grid);
    if (!has_ground(scenario)) return {};
    const Field<double> stated = stated_ground(scenario);
    Field<float> heights(grid.nx, grid.ny);
    std::copy_n(stated.data(), stated.size(), heights.data());
    return heights;
}

}  // namespace waterlight
