#include "caustics/beam_image.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "caustics/beam_enlarge.hpp"
#include "caustics/beam_strip.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

void validate(const BeamImageSettings& s, const Beams& beams) {
    const Camera& c = s.camera;
    if (c.size.x < 1 || c.size.y < 1)
        throw InputError(fmt::format("camera: size is {} x {} pixels; at least 1 x 1", c.size.x, c.size.y));
    if (!(c.fov_deg > 0 && c.fov_deg < 180)) throw InputError("camera: fov_deg must be in (0, 180)");
    if (c.position_m == c.target_m) throw InputError("camera: it must not stand on its target");
    if (!(c.position_m.z < beams.highest_m && c.position_m.z > -beams.depth_m))
        throw InputError(fmt::format("camera: its height is {} m; below the surface and above the floor at -{} m",
                                     c.position_m.z, beams.depth_m));
    if (s.samples < 1) throw InputError("camera: samples must be at least 1");
    if (s.reduction < 1) throw InputError("camera: reduction must be at least 1");
    if (!(s.range_m > 0)) throw InputError("camera: range_m must be above 0");
    if (std::abs(s.optics.extinction_per_m() - beams.extinction_per_m) > 1e-12)
        throw InputError("camera: the beams were made for another extinction");
}

/// A cell whose beams the picture shows, and the columns that its outline covers.
struct ShownCell {
    CellCopy copy;
    int first_column = 0;
    int last_column = 0;
};

/// Whole periods along one axis that lie within `range` of the camera.
struct Copies {
    int first = 0;
    int last = 0;
    Copies(Side side, double from, double extent, double camera, double range) {
        if (side != Side::periodic) return;
        first = static_cast<int>(std::floor((camera - range - from) / extent));
        last = static_cast<int>(std::floor((camera + range - from) / extent));
    }
};

/// Whether the box of a cell's beams comes within range of the camera.
bool in_range(const std::array<glm::vec3, 8>& corners, float range) {
    glm::vec3 low = corners[0], high = corners[0];
    for (const glm::vec3& p : corners) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const glm::vec3 nearest = glm::clamp(glm::vec3{0, 0, 0}, low, high);
    return glm::dot(nearest, nearest) <= range * range;
}

std::vector<ShownCell> shown_in_row(const BeamImageSettings& s, const Beams& beams, int j) {
    const Camera::Rays rays = s.camera.rays();
    const glm::dvec3 eye = s.camera.position_m;
    const Grid& g = beams.domain;
    const Copies along_x(beams.boundary.x, g.x0_m, g.width_m(), eye.x, s.range_m);
    const Copies along_y(beams.boundary.y, g.y0_m, g.height_m(), eye.y, s.range_m);
    const float width = static_cast<float>(s.camera.size.x), height = static_cast<float>(s.camera.size.y);
    std::vector<ShownCell> shown;
    for (int q = along_y.first; q <= along_y.last; ++q) {
        for (int p = along_x.first; p <= along_x.last; ++p) {
            const glm::vec2 shift{p * g.width_m(), q * g.height_m()};
            for (int i = 0; i < beams.nx; ++i) {
                if (!(beams.flux(2 * i, j) + beams.flux(2 * i + 1, j) > 0)) continue;
                const CellCopy copy{i, j, shift};
                const std::array<glm::vec3, 8> corners = beam_corners(beams, copy, eye);
                if (!in_range(corners, static_cast<float>(s.range_m))) continue;
                const BeamOutline outline(rays, corners);
                if (outline.empty() || outline.right() < 0 || outline.left() > width - 1 || outline.top() < 0 ||
                    outline.bottom() > height - 1)
                    continue;
                const int first = static_cast<int>(std::ceil(std::max(outline.left(), 0.0F)));
                const int last = static_cast<int>(std::floor(std::min(outline.right(), width - 1)));
                if (first <= last) shown.push_back({copy, first, last});
            }
        }
    }
    return shown;
}

std::vector<ShownCell> shown_cells(const BeamImageSettings& s, const Beams& beams) {
    std::vector<std::vector<ShownCell>> rows(beams.ny);
#pragma omp parallel for schedule(dynamic, 4)
    for (int j = 0; j < beams.ny; ++j) rows[j] = shown_in_row(s, beams, j);
    std::vector<ShownCell> all;
    for (const std::vector<ShownCell>& row : rows) all.insert(all.end(), row.begin(), row.end());
    return all;
}

/// The cells of each strip of columns.
std::vector<std::vector<CellCopy>> sort_into_strips(const std::vector<ShownCell>& shown, int strips) {
    std::vector<std::vector<CellCopy>> strip(strips);
    for (const ShownCell& cell : shown)
        for (int k = cell.first_column / BeamStrip::columns; k <= cell.last_column / BeamStrip::columns; ++k)
            strip[k].push_back(cell.copy);
    return strip;
}

template <class PhaseFunction>
void draw(const BeamImageSettings& s, const Beams& beams, const PhaseFunction& phase, BeamImage& image) {
    const glm::ivec2 size = s.camera.size;
    const int strips = (size.x + BeamStrip::columns - 1) / BeamStrip::columns;
    const std::vector<ShownCell> shown = shown_cells(s, beams);
    const std::vector<std::vector<CellCopy>> in_strip = sort_into_strips(shown, strips);
    std::int64_t sections = 0, covered = 0;
#pragma omp parallel reduction(+ : sections, covered)
    {
        BeamStrip strip(s, beams);
#pragma omp for schedule(dynamic, 1)
        for (int k = 0; k < strips; ++k) {
            strip.begin(k * BeamStrip::columns);
            for (const CellCopy& copy : in_strip[k]) sections += strip.add(copy, phase);
            covered += strip.finish(image.radiance);
        }
    }
    image.counts = {2 * static_cast<std::int64_t>(shown.size()), covered, sections};
}

void draw(const BeamImageSettings& settings, const Beams& beams, BeamImage& image) {
    const glm::ivec2 size = settings.camera.size;
    if (image.radiance.nx() != size.x || image.radiance.ny() != size.y) image.radiance = Field<float>(size.x, size.y);
    const Phase& phase = settings.optics.phase;
    if (phase.type == Phase::Type::henyey_greenstein)
        draw(settings, beams, HenyeyGreenstein{static_cast<float>(phase.g)}, image);
    else
        draw(settings, beams, PhaseTable(phase), image);
}

}  // namespace

void draw_beams(const BeamImageSettings& settings, const Beams& beams, BeamImage& image) {
    validate(settings, beams);
    if (settings.reduction == 1) return draw(settings, beams, image);
    BeamImageSettings fewer = settings;
    fewer.camera = reduced(settings.camera, settings.reduction);
    BeamImage coarse;
    draw(fewer, beams, coarse);
    image.counts = coarse.counts;
    const glm::ivec2 size = settings.camera.size;
    if (image.radiance.nx() != size.x || image.radiance.ny() != size.y) image.radiance = Field<float>(size.x, size.y);
    enlarge(settings, beams, coarse.radiance, image.radiance);
}

}  // namespace waterlight
