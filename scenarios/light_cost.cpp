#include "scenarios/light_cost.hpp"

#include <algorithm>
#include <cmath>

#include "caustics/sun_disc.hpp"
#include "scenarios/costs.hpp"
#include "scenarios/resolve.hpp"
#include "scenarios/resolve_light.hpp"

namespace waterlight {

namespace {

/// How many times the map of parallel light that of the sun's disc takes.
double disc_factor(const Scenario& s, glm::ivec2 pixels) {
    if (!s.sun.disc_deg || s.light.elevation_deg <= 0) return 1;
    Scenario sized = s;
    sized.floor->pixels = pixels;
    const Spread spread = disc_spread(floor_settings(sized), *s.sun.disc_deg);
    const double radius = 2 * std::sqrt(std::max(spread.xx, spread.yy));
    return costs::disc_factor + radius * costs::disc_factor_a_pixel;
}

bool is_followed(const Scenario& s) { return !s.objects.empty() || s.lamp; }

/// Of one wavelength's map by a method that looks from the light.
double light_image_seconds(const Scenario& s, glm::ivec2 pixels, glm::ivec2 cells) {
    if (s.floor->method == FloorMethod::splat)
        return vertices_of(s) * (is_followed(s) ? costs::splat_object_vertex_frame : costs::splat_vertex_frame) +
               product(pixels) * costs::splat_pixel_frame;
    if (!is_followed(s)) return photons_of(s) * costs::photon_frame;
    return photons_of(s) * costs::photon_object_frame + product(cells) * costs::photon_cell_frame;
}

/// Of one map.
double floor_seconds(const Scenario& s, glm::ivec2 pixels, glm::ivec2 cells) {
    const FloorSection& floor = *s.floor;
    const double bands = std::max<double>(1, static_cast<double>(bands_of(s).size()));
    if (floor.method == FloorMethod::splat || floor.method == FloorMethod::photons)
        return bands * disc_factor(s, pixels) * light_image_seconds(s, pixels, cells);
    if (floor.on.receiver == Receiver::ground) return bands * product(pixels) * costs::relief_pixel_frame;
    if (floor.method == FloorMethod::truth) return product(pixels) * costs::truth_pixel_frame;
    const double sample = floor.method == FloorMethod::quads    ? costs::quad_frame
                          : floor.footprint == Footprint::pixel ? costs::floor_pixel_frame
                                                                : costs::floor_parallelogram_frame;
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

double vertices_of(const Scenario& s) {
    const glm::dvec2 size = s.domain.size_m / std::max(s.domain.size_m.x, s.domain.size_m.y);
    return s.floor->splat.grid * static_cast<double>(s.floor->splat.grid) * size.x * size.y;
}

double photons_of(const Scenario& s) {
    return s.floor->photons.map * static_cast<double>(s.floor->photons.map) * s.floor->photons.passes;
}

double light_seconds(const Scenario& s, const LightDemand& light, glm::ivec2 cells) {
    const double moments = moments_of_run(s), frames = frames_of_run(s);
    double seconds = 0;
    if (s.floor) seconds += moments * floor_seconds(s, light.pixels, cells);
    if (s.walls) {
        const double bands = std::max<double>(1, static_cast<double>(bands_of(s).size()));
        seconds += frames * bands * product(cells) * costs::wall_cell_frame;
    }
    if (!s.beams) return seconds;
    return seconds + moments * 2 * product(light.beams) * costs::beam_frame + frames * water_seconds(s, light.beams);
}

double scene_seconds(const Scenario& s) {
    if (!s.output.image) return 0;
    if (traces_pictures(s)) {
        const double samples = s.picture.look.samples * s.picture.look.samples;
        return frames_of_run(s) * product(s.camera->camera.size) * samples * costs::traced_sample_frame;
    }
    const double pixel = costs::scene_pixel_frame + s.picture.look.samples * costs::scene_sample_frame;
    return frames_of_run(s) * (costs::scene_frame + product(s.camera->camera.size) * pixel);
}

}  // namespace waterlight
