#include "caustics/beam_image.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "caustics/beam_outline.hpp"
#include "caustics/beam_picture.hpp"
#include "caustics/beam_strip.hpp"

namespace waterlight {

namespace {

/// A cell whose beams the picture shows, and the columns that its outline covers.
struct ShownCell {
    CellCopy copy;
    int first_column = 0;
    int last_column = 0;
};

std::vector<ShownCell> shown_in_row(const BeamImageSettings& s, const Beams& beams,
                                    const std::vector<glm::vec2>& shifts, int j) {
    const Viewpoint view(s.camera);
    const float last_column = static_cast<float>(s.camera.size.x - 1);
    std::vector<ShownCell> shown;
    for (const glm::vec2 shift : shifts) {
        for (int i = 0; i < beams.nx; ++i) {
            if (!(beams.flux(2 * i, j) + beams.flux(2 * i + 1, j) > 0)) continue;
            const CellCopy copy{i, j, shift};
            const std::array<glm::vec3, 8> corners = beam_corners(beams, copy, view.eye_m);
            if (!in_range(corners, s.range_m)) continue;
            const BeamOutline outline(view.rays, corners);
            if (!in_frame(outline, s.camera.size)) continue;
            const int first = static_cast<int>(std::ceil(std::max(outline.left(), 0.0F)));
            const int last = static_cast<int>(std::floor(std::min(outline.right(), last_column)));
            if (first <= last) shown.push_back({copy, first, last});
        }
    }
    return shown;
}

std::vector<ShownCell> shown_cells(const BeamImageSettings& s, const Beams& beams) {
    const std::vector<glm::vec2> shifts = copies_in_sight(s, beams);
    std::vector<std::vector<ShownCell>> rows(beams.ny);
#pragma omp parallel for schedule(dynamic, 4)
    for (int j = 0; j < beams.ny; ++j) rows[j] = shown_in_row(s, beams, shifts, j);
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
void draw(const BeamImageSettings& s, const Beams& beams, const Field<float>& reach, const PhaseFunction& phase,
          BeamImage& image) {
    const glm::ivec2 size = s.camera.size;
    const int strips = (size.x + BeamStrip::columns - 1) / BeamStrip::columns;
    const std::vector<ShownCell> shown = shown_cells(s, beams);
    const std::vector<std::vector<CellCopy>> in_strip = sort_into_strips(shown, strips);
    std::int64_t sections = 0, covered = 0;
#pragma omp parallel reduction(+ : sections, covered)
    {
        BeamStrip strip(s, beams, reach);
#pragma omp for schedule(dynamic, 1)
        for (int k = 0; k < strips; ++k) {
            strip.begin(k * BeamStrip::columns);
            for (const CellCopy& copy : in_strip[k]) sections += strip.add(copy, phase);
            covered += strip.finish(image.radiance);
        }
    }
    image.counts = {2 * static_cast<std::int64_t>(shown.size()), covered, sections};
}

void draw(const BeamImageSettings& settings, const Beams& beams, const Field<float>& reach, BeamImage& image) {
    resize(settings, image);
    const Phase& phase = settings.optics.phase;
    if (phase.type == Phase::Type::henyey_greenstein)
        draw(settings, beams, reach, HenyeyGreenstein{static_cast<float>(phase.g)}, image);
    else
        draw(settings, beams, reach, PhaseTable(phase), image);
}

}  // namespace

void draw_beams(const BeamImageSettings& settings, const Beams& beams, BeamImage& image) {
    validate(settings, beams);
    draw_reduced(
        settings, beams,
        [](const BeamImageSettings& all, const Beams& some, const Field<float>& reach, BeamImage& out) {
            draw(all, some, reach, out);
        },
        image);
}

}  // namespace waterlight
