#include "scenarios/memory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "scenarios/light_cost.hpp"
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
// Sums in double precision beside the map: of a pass, of all, their squares, and what is smoothed.
constexpr double photon_pixel = 100;
// The map and its sum in double precision; and each vertex with where it lands, its power and its neighbours.
constexpr double splat_pixel = 64;
constexpr double splat_vertex = 90;
// Each of two triangles of a cell of the water, and the boxes by which light finds them.
constexpr double water_triangle = 180;

// Bytes a cell of the fields in the water: both of them, and four of each that wait to be written.
constexpr double volume_cell = 50;

// Bytes of Beams: eight floats a corner, the flux of two beams a cell; and of what a thread that fills fields has of
// it: three floats a corner, two sums a cell of a slice.
constexpr double beam_corner = 8 * 4;
constexpr double beam_cell = 2 * 4;
constexpr double landed_corner = 3 * 4;
constexpr double slice_cell = 2 * 8;
// Of a picture: a cell's place in the lists of what it shows, in its strip's too; a pixel, how far it sees, four that
// wait to be written, their colours, and the ways of pictures that are enlarged; five floats a pixel of a thread's
// strip.
constexpr double shown_cell = 80;
constexpr double picture_pixel = 40;
constexpr double strip_pixel = 5 * 4;
// Of walls: the map, its power in double precision, what lands on it in lists, four that wait and their colours.
constexpr double wall_pixel = 60;

// Of a picture of the scene: the device's programs; its targets, by pixel and by sample of it; eight bits of three
// colours, four of those that wait to be written and one at work.
constexpr double scene_device = 64e6;
constexpr double scene_sample = 4 * 4 + 4;
constexpr double scene_pixel = 4 * 4 + 4 + 4 + 5 * 3;

double bytes_per_cell(ModelChoice model) {
    if (model == ModelChoice::linear) return linear_cell;
    if (model == ModelChoice::shallow_water) return shallow_water_cell;
    return model == ModelChoice::prescribed ? prescribed_cell : airy_cell;
}

double bytes_per_pixel(const FloorSection& floor, bool estimates) {
    const double more_samples = floor.samples_per_pixel * floor.samples_per_pixel - 1;
    double map = floor.footprint == Footprint::adaptive ? adaptive_pixel + more_samples * adaptive_sample
                                                        : two_pass_pixel + more_samples * two_pass_sample;
    if (floor.method == FloorMethod::truth) map = truth_pixel;
    if (floor.method == FloorMethod::photons) map = photon_pixel;
    if (floor.method == FloorMethod::splat) map = splat_pixel;
    return estimates ? map + truth_pixel : map;
}

/// The model's own cells and, where errors are estimated, those of the models alongside (WaveEstimate).
double solutions(const Scenario& scenario, ModelChoice model) {
    if (!scenario.accuracy.estimate || model == ModelChoice::prescribed) return 1;
    return model == ModelChoice::airy ? 10 : 1 + 1 / 4.0 + 1 / 16.0;
}

double threads() { return std::max(1.0, static_cast<double>(::sysconf(_SC_NPROCESSORS_ONLN))); }

double bytes_of_grid(glm::ivec2 grid) { return product(grid + 1) * beam_corner + product(grid) * beam_cell; }

/// Of the grids and of the threads that fill fields from them.
double bytes_of_beams(const BeamsSection& beams) {
    const glm::ivec2 n = beams.grid;
    double bytes = bytes_of_grid(n) * (beams.reflected ? 2 : 1);
    if (beams.refine_below) bytes += bytes_of_grid(n) + bytes_of_grid(2 * n);
    if (!beams.volume_cells) return bytes;
    const double slice = product({beams.volume_cells->x, beams.volume_cells->y}) * slice_cell;
    return bytes + threads() * (product(n + 1) * landed_corner + slice);
}

double bytes_of_picture(const Scenario& s) {
    const glm::ivec2 size = s.camera->camera.size;
    constexpr double strip_columns = 32;
    const double cells = product(s.beams->grid) * (s.beams->refine_below ? 4 : 1);
    return product(size) * picture_pixel + threads() * strip_columns * size.y * strip_pixel + cells * shown_cell;
}

double bytes_of_walls(const Scenario& s) {
    if (s.domain.cells.x == 0) return 0;
    const Boundary sides = resolve_boundary(s);
    double pixels = 0;
    for (int wall = 0; wall < 4; ++wall) {
        if ((wall < 2 ? sides.x : sides.y) != Side::wall) continue;
        const WallPlan plan = wall_plan(wall_settings(s), grid_of(s), wall);
        pixels += product({plan.columns, plan.rows});
    }
    return pixels * wall_pixel * std::max<double>(1, static_cast<double>(bands_of(s).size()));
}

/// What methods that look from the light have beside their maps.
double bytes_of_light(const Scenario& s) {
    const FloorMethod method = s.floor->method;
    const bool looks_up = method == FloorMethod::photons || (method == FloorMethod::splat && !s.objects.empty());
    return (looks_up ? 2 * product(s.domain.cells) * water_triangle : 0) +
           (method == FloorMethod::splat ? vertices_of(s) * splat_vertex : 0);
}

double bytes_of_scene(const Scenario& s) {
    return scene_device + product(s.camera->camera.size) * (scene_pixel + scene_sample * s.picture.look.samples);
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
    if (scenario.beams) estimate.beams = bytes_of_beams(*scenario.beams);
    if (sees_scattered_light(scenario)) estimate.picture = bytes_of_picture(scenario);
    if (scenario.output.image) estimate.scene = bytes_of_scene(scenario);
    if (scenario.walls) estimate.walls = bytes_of_walls(scenario);
    if (!scenario.floor) return estimate;
    const glm::ivec2 pixels = scenario.floor->pixels;
    const double maps = std::max<double>(1, static_cast<double>(bands_of(scenario).size()));
    estimate.pixels =
        pixels.x * static_cast<double>(pixels.y) * bytes_per_pixel(*scenario.floor, scenario.accuracy.estimate) * maps;
    estimate.light = bytes_of_light(scenario) * maps;
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

namespace {

/// A part of the estimate, the key that makes it large and what that says.
struct MemoryPart {
    double bytes = 0;
    std::string key, value;
    std::string each;  ///< "260 bytes a cell"; empty where several things add up
};

std::vector<MemoryPart> parts_of(const Scenario& s, const MemoryEstimate& estimate) {
    const auto pair = [](glm::ivec2 n) { return fmt::format("[{}, {}]", n.x, n.y); };
    const auto each = [](double bytes, glm::ivec2 n, const char* of) {
        return fmt::format(" ({:.0f} bytes a {})", bytes / product(n), of);
    };
    std::vector<MemoryPart> parts{
        {estimate.cells, "domain.cells", pair(s.domain.cells), each(estimate.cells, s.domain.cells, "cell")}};
    if (s.floor)
        parts.push_back({estimate.pixels, "caustics.floor.pixels", pair(s.floor->pixels),
                         each(estimate.pixels, s.floor->pixels, "pixel")});
    if (s.floor && s.floor->method == FloorMethod::splat)
        parts.push_back({estimate.light, "caustics.floor.splat.grid", fmt::format("{}", s.floor->splat.grid), {}});
    if (s.beams) parts.push_back({estimate.beams, "caustics.beams.grid", pair(s.beams->grid), {}});
    if (s.beams && s.beams->volume_cells) {
        const glm::ivec3 v = *s.beams->volume_cells;
        parts.push_back(
            {estimate.volume, "caustics.beams.volume_cells", fmt::format("[{}, {}, {}]", v.x, v.y, v.z), {}});
    }
    if (s.camera)
        parts.push_back({estimate.picture + estimate.scene, "camera.pixels", pair(s.camera->camera.size), {}});
    if (s.walls) parts.push_back({estimate.walls, "caustics.walls.pixel_m", fmt::format("{}", s.walls->pixel_m), {}});
    return parts;
}

}  // namespace

void check_memory(const Scenario& scenario, double available) {
    const MemoryEstimate estimate = estimate_memory(scenario);
    if (estimate.total() <= available) return;
    const std::vector<MemoryPart> parts = parts_of(scenario, estimate);
    const MemoryPart& largest = *std::max_element(
        parts.begin(), parts.end(), [](const MemoryPart& a, const MemoryPart& b) { return a.bytes < b.bytes; });
    scenario.origin.reject(
        largest.key, fmt::format("{}, which takes some {}", largest.value, in_gib(estimate.total())),
        fmt::format("what fits the {} of memory that this machine has free{}", in_gib(available), largest.each));
}

}  // namespace waterlight
