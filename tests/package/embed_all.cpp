// A tool that lists devices and reads a scenario.
#include "export/ticks.hpp"
#include "gpu/device.hpp"
#include "render/scene_renderer.hpp"
#include "scenarios/build.hpp"
#include "scenarios/reader.hpp"

int main() {
    using namespace waterlight;
    const Scenario scenario = parse_scenario("[domain]\nsize_m = [1, 1]\ncells = [8, 8]\ndepth_m = 1\n", "inline");
    const BuiltModel built = build_model(scenario);
    const Look look;
    const bool is_still = built.model->diagnostics().max_abs_elevation_m == 0;
    return is_still && look.samples > 0 && !gpu::survey().explanation.empty() && !round_ticks({0, 1}, 5).empty() ? 0
                                                                                                                 : 1;
}
