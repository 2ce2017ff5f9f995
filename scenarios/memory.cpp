#include "scenarios/memory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#include "scenarios/resolve.hpp"
#include "scenarios/resolve_light.hpp"

namespace waterlight {

namespace {

// Bytes a cell, a quarter above the peaks measured (docs/performance.md): the model's state and its surface, and four
// elevations and depths that wait to be written; and the state once more, of a checkpoint that waits.
constexpr double linear_cell = 92 + 9;
constexpr double airy_cell = 100 + 16;
constexpr double shallow_water_cell = 260 + 29;
constexpr double prescribed_cell = 60;
// Bytes a pixel: landed samples, the map, four that wait to be written, a picture; and of each sample more.
constexpr double two_pass_pixel = 56;
constexpr double two_pass_sample = 24;
constexpr double adaptive_pixel = 80;
constexpr double adaptive_sample = 48;
// In double precision, with the two solutions that are compared.
constexpr double truth_pixel = 120;

// Bytes a cell of the fields in the water: both of them, and four of each that wait to be written.
constexpr double volume_cell = 50;

double bytes_per_cell(ModelChoice model) {
    if (model == ModelChoice::linear) return linear_cell;
    if (model == ModelChoice::shallow_water) return shallow_water_cell;
    return model == ModelChoice::prescribed ? prescribed_cell : airy_cell;
}

double bytes_per_pixel(const FloorSection& floor, bool estimates) {
    if (floor.method == FloorMethod::truth) return truth_pixel;
    const double more_samples = floor.samples_per_pixel * floor.samples_per_pixel - 1;
    const double map = floor.footprint == Footprint::adaptive ? adaptive_pixel + more_samples * adaptive_sample
                                                              : two_pass_pixel + more_samples * two_pass_sample;
    return estimates ? map + truth_pixel : map;
}

/// The model's own cells and, where errors are estimated, those of the models alongside (WaveEstimate).
double solutions(const Scenario& scenario, ModelChoice model) {
    if (!scenario.accuracy.estimate || model == ModelChoice::prescribed) return 1;
    return model == ModelChoice::airy ? 10 : 1 + 1 / 4.0 + 1 / 16.0;
}

std::string in_gib(double bytes) { return fmt::format("{:.3g} GiB", bytes / (1 << 30)); }

double number_in_file(const char* path, const std::string& label) {
    std::ifstream file(path);
    std::string word;
    double value = 0;
    if (label.empty()) return file >> value ? value : 0;
    while (file >> word)
        if (word == label && file >> value) return value;
    return 0;
}

}  // namespace

MemoryEstimate estimate_memory(const Scenario& scenario) {
    const Boundary boundary = resolve_boundary(scenario);
    const ModelChoice model = resolve_model(scenario).model;
    const auto with_margins = [&](Side side, double length_m) {
        if (side != Side::absorbing || model == ModelChoice::shallow_water) return 1.0;
        return scenario.waves.margin_m ? 1 + 2 * *scenario.waves.margin_m / length_m : 2.0;
    };
    const double margins =
        with_margins(boundary.x, scenario.domain.size_m.x) * with_margins(boundary.y, scenario.domain.size_m.y);
    const glm::ivec2 n = scenario.domain.cells;
    MemoryEstimate estimate;
    estimate.cells = margins * n.x * static_cast<double>(n.y) * bytes_per_cell(model) * solutions(scenario, model);
    if (scenario.beams && scenario.beams->volume_cells) {
        const glm::dvec3 v(*scenario.beams->volume_cells);
        estimate.volume = v.x * v.y * v.z * volume_cell;
    }
    if (!scenario.floor) return estimate;
    const glm::ivec2 pixels = scenario.floor->pixels;
    const double maps = std::max<double>(1, static_cast<double>(bands_of(scenario).size()));
    estimate.pixels =
        pixels.x * static_cast<double>(pixels.y) * bytes_per_pixel(*scenario.floor, scenario.accuracy.estimate) * maps;
    return estimate;
}

/// What the process may still ask for, as `ulimit -v` limits it.
static double address_space_left() {
    rlimit limit{};
    if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
        return std::numeric_limits<double>::infinity();
    const double used = number_in_file("/proc/self/statm", "") * static_cast<double>(::sysconf(_SC_PAGESIZE));
    return std::max(0.0, static_cast<double>(limit.rlim_cur) - used);
}

double machine_memory() {
    constexpr double kib = 1024;
    const double available = std::min(number_in_file("/proc/meminfo", "MemAvailable:") * kib, address_space_left());
    const double limit = number_in_file("/sys/fs/cgroup/memory.max", "");
    return limit > 0 ? std::min(available, limit) : available;
}

void check_memory(const Scenario& scenario, double available) {
    const MemoryEstimate estimate = estimate_memory(scenario);
    if (estimate.total() <= available) return;
    if (estimate.volume > std::max(estimate.cells, estimate.pixels)) {
        const glm::ivec3 v = *scenario.beams->volume_cells;
        scenario.origin.reject(
            "caustics.beams.volume_cells",
            fmt::format("[{}, {}, {}], which takes some {}", v.x, v.y, v.z, in_gib(estimate.total())),
            fmt::format("what fits the {} of memory that this machine has free", in_gib(available)));
    }
    const bool cells_dominate = estimate.cells >= estimate.pixels;
    const glm::ivec2 n = cells_dominate ? scenario.domain.cells : scenario.floor->pixels;
    scenario.origin.reject(
        cells_dominate ? "domain.cells" : "caustics.floor.pixels",
        fmt::format("[{}, {}], which takes some {}", n.x, n.y, in_gib(estimate.total())),
        fmt::format("what fits the {} of memory that this machine has free ({:.0f} bytes a {})", in_gib(available),
                    (cells_dominate ? estimate.cells : estimate.pixels) / (static_cast<double>(n.x) * n.y),
                    cells_dominate ? "cell" : "pixel"));
}

}  // namespace waterlight
