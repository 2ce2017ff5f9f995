#include "caustics/beam_refine.hpp"

#include <algorithm>

#include "caustics/beam_renderer.hpp"
#include "caustics/kernels/beams.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

/// The least of a y^2 + b y + c, which is positive at 0, from 0 to `end`, over that at 0.
float least_share(glm::vec3 p, float end) {
    float least = std::min(p.z, (p.x * end + p.y) * end + p.z);
    const float turn = p.x != 0 ? -0.5F * p.y / p.x : 0;
    if (turn > 0 && turn < end) least = std::min(least, (p.x * turn + p.y) * turn + p.z);
    return least / p.z;
}

/// How far the section of a beam shrinks between the surface and the floor; below 0 where it folds.
float shrinks_to(const Beams& b, int beam, int row) {
    const std::array<glm::ivec2, 3> at = corners_of(beam, row);
    std::array<glm::vec2, 3> place, travel;
    float height = 0;
    for (int k = 0; k < 3; ++k) {
        const int i = at[k].x, j = at[k].y;
        // Sections are horizontal; corners are followed to still water.
        travel[k] = {b.travel_x(i, j), b.travel_y(i, j)};
        place[k] = glm::vec2(b.x(i, j), b.y(i, j)) + b.z(i, j) * travel[k];
        height += b.z(i, j) / 3;
    }
    glm::vec3 area =
        f32::area_polynomial(place[1] - place[0], place[2] - place[0], travel[1] - travel[0], travel[2] - travel[0]);
    if (area.z < 0) area = -area;
    return area.z > 0 ? least_share(area, static_cast<float>(b.depth_m) + height) : 1;
}

/// Leaves out the pieces of beams in cells that are not this grid's.
template <class Kept>
void keep_pieces(Beams& beams, Kept kept) {
    if (!beams.pieces) return;
    BeamPieces& pieces = *beams.pieces;
    for (std::size_t k = 0; k < pieces.of.size(); ++k)
        if (!kept(pieces.of[k].x / 2, pieces.of[k].y)) pieces.beams.flux(4 * static_cast<int>(k), 0) = 0;
}

}  // namespace

void make_refined_beams(const BeamSettings& settings, double share, const Surface& surface, RefinedBeams& beams) {
    if (!(share > 0 && share < 1)) throw InputError("beams: the share from which to refine must be in (0, 1)");
    make_beams(settings, surface, beams.coarse);
    BeamSettings twice = settings;
    twice.grid = 2 * settings.grid;
    make_beams(twice, surface, beams.fine);
    Beams &coarse = beams.coarse, &fine = beams.fine;
    int refined = 0;
    Field<char> is_refined(coarse.nx, coarse.ny);
#pragma omp parallel for schedule(static) reduction(+ : refined)
    for (int j = 0; j < coarse.ny; ++j) {
        for (int i = 0; i < coarse.nx; ++i) {
            const bool converges = std::min(shrinks_to(coarse, 2 * i, j), shrinks_to(coarse, 2 * i + 1, j)) < share;
            is_refined(i, j) = converges ? 1 : 0;
            if (converges) {
                coarse.flux(2 * i, j) = coarse.flux(2 * i + 1, j) = 0;
                ++refined;
                continue;
            }
            for (int row = 2 * j; row < 2 * j + 2; ++row)
                for (int b = 4 * i; b < 4 * i + 4; ++b) fine.flux(b, row) = 0;
        }
    }
    beams.refined_cells = refined;
    keep_pieces(coarse, [&](int i, int j) { return is_refined(i, j) == 0; });
    keep_pieces(fine, [&](int i, int j) { return is_refined(i / 2, j / 2) != 0; });
}

void draw_beams(const BeamImageSettings& settings, const RefinedBeams& beams, BeamImage& image) {
    draw_beams(*make_beam_renderer_cpu(), settings, beams, image);
}

}  // namespace waterlight
