#include "scenarios/light_cost.hpp"

#include <algorithm>
#include <cmath>

#include "caustics/sun_disc.hpp"
#include "scenarios/costs.hpp"
#include "scenarios/resolve.hpp"
#include "scenarios/resolve_light.hpp"

namespace waterlight {

namespace {

double product(glm::ivec2 n) { return n.x * static_cast<double>(n.y); }

/// How many times the map of parallel light that of the sun's disc takes.
double disc_factor(const Scenario& s, glm::ivec2 pixels) {
    if (!s.sun.disc_deg || s.light.elevation_deg <= 0) return 1;
    Scenario sized = s;
    sized.floor->pixels = pixels;
    const Spread spread = disc_spread(floor_settings(sized), *s.sun.disc_deg);
    const double radius = 2 * std::sqrt(std::max(spread.xx, spread.yy));
    return costs::disc_factor + radius * costs::disc_factor_a_pixel;
}

/// Of one map.
double floor_seconds(const Scenario& s, glm::ivec2 pixels) {
    const FloorSection& floor = *s.floor;
    const double bands = std::max<double>(1, static_cast<double>(bands_of(s).size()));
    if (floor.on.receiver == Receiver::ground) return bands * product(pixels) * costs::relief_pixel_frame;
    if (floor.method == FloorMethod::truth) return product(pixels) * costs::truth_pixel_frame;
    const double sample =
        floor.footprint == Footprint::pixel ? costs::floor_pixel_frame : costs::floor_parallelogram_frame;
    const double samples = product(pixels) * floor.samples_per_pixel * floor.samples_per_pixel;
    return bands * disc_factor(s, pixels) * samples * sample;
}

/// Of one frame's fields and picture, and of the beams that are made for them alone.
double water_seconds(const Scenario& s, glm::ivec2 grid) {
    const BeamsSection& section = *s.beams;
    const double beams = 2 * product(grid);
    double seconds = 0;
    if (section.reflected) seconds += beams * costs::beam_frame;
    if (section.volume_cells) seconds += beams * section.volume_cells->z * costs::beam_slice_frame;
    if (!sees_scattered_light(s)) return seconds;
    const double rays = product(s.camera->camera.size) / (s.camera->reduction * s.camera->reduction);
    seconds += rays * std::max(grid.x, grid.y) * costs::picture_pixel_column_frame;
    // The coarse grid once more, and one with four times the beams; of their rays half are left.
    if (section.refine_below) seconds += 5 * beams * costs::beam_frame;
    return seconds;
}

}  // namespace

double light_seconds(const Scenario& s, const LightDemand& light, glm::ivec2 cells) {
    const double moments = moments_of_run(s), frames = frames_of_run(s);
    double seconds = 0;
    if (s.floor) seconds += moments * floor_seconds(s, light.pixels);
    if (s.walls) {
        const double bands = std::max<double>(1, static_cast<double>(bands_of(s).size()));
        seconds += frames * bands * product(cells) * costs::wall_cell_frame;
    }
    if (!s.beams) return seconds;
    return seconds + moments * 2 * product(light.beams) * costs::beam_frame + frames * water_seconds(s, light.beams);
}

double scene_seconds(const Scenario& s) {
    if (!s.output.image) return 0;
    const double pixel = costs::scene_pixel_frame + s.picture.look.samples * costs::scene_sample_frame;
    return frames_of_run(s) * (costs::scene_frame + product(s.camera->camera.size) * pixel);
}

}  // namespace waterlight
