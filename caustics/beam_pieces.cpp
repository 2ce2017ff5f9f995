#include "caustics/beam_pieces.hpp"

#include <algorithm>

namespace waterlight {

BeamTriangle triangle_of(const Beams& beams, int b, int j) {
    const std::array<glm::ivec2, 3> at = corners_of(b, j);
    BeamTriangle t;
    for (int k = 0; k < 3; ++k) {
        const int i = at[k].x, row = at[k].y;
        t[k] = {{beams.x(i, row), beams.y(i, row), beams.z(i, row)},
                {beams.travel_x(i, row), beams.travel_y(i, row)},
                beams.path(i, row),
                beams.end_z(i, row),
                beams.transmittance(i, row)};
    }
    return t;
}

namespace {

/// Piece k as beam 0 of cell 2 k: the cells between keep corners apart. The fourth corner is the middle of the others,
/// so that means over the cell are those of the piece.
void store(const CutBeam& cut, int k, Beams& beams) {
    BeamCorner middle;
    for (const BeamCorner& c : cut.piece.corner) {
        middle.at_m += c.at_m / 3.0;
        middle.travel += c.travel / 3.0;
        middle.path += c.path / 3;
        middle.end_z += c.end_z / 3;
        middle.transmittance += c.transmittance / 3;
    }
    const auto put = [&](int i, int j, const BeamCorner& c) {
        beams.x(i, j) = static_cast<float>(c.at_m.x);
        beams.y(i, j) = static_cast<float>(c.at_m.y);
        beams.z(i, j) = static_cast<float>(c.at_m.z);
        beams.travel_x(i, j) = static_cast<float>(c.travel.x);
        beams.travel_y(i, j) = static_cast<float>(c.travel.y);
        beams.path(i, j) = static_cast<float>(c.path);
        beams.end_z(i, j) = static_cast<float>(c.end_z);
        beams.transmittance(i, j) = static_cast<float>(c.transmittance);
    };
    put(2 * k, 0, cut.piece.corner[0]);
    put(2 * k + 1, 0, cut.piece.corner[1]);
    put(2 * k + 1, 1, cut.piece.corner[2]);
    put(2 * k, 1, middle);
    beams.flux(4 * k, 0) = static_cast<float>(cut.flux_w);
}

}  // namespace

std::shared_ptr<BeamPieces> gather(const Beams& whole, const std::vector<std::vector<CutBeam>>& rows) {
    int count = 0;
    for (const std::vector<CutBeam>& row : rows)
        count += static_cast<int>(std::ranges::count_if(row, [](const CutBeam& c) { return c.flux_w > 0; }));
    if (count == 0) return nullptr;
    auto pieces = std::make_shared<BeamPieces>();
    Beams& b = pieces->beams;
    b.domain = whole.domain;
    b.boundary = whole.boundary;
    b.depth_m = whole.depth_m;
    b.extinction_per_m = whole.extinction_per_m;
    b.time_s = whole.time_s;
    b.mirrored = whole.mirrored;
    b.lowest_m = whole.lowest_m;
    b.highest_m = whole.highest_m;
    b.ground = whole.ground;
    resize(b, {2 * count - 1, 1});
    b.flux.fill(0);
    for (const std::vector<CutBeam>& row : rows)
        for (const CutBeam& cut : row) {
            if (!(cut.flux_w > 0)) continue;
            store(cut, static_cast<int>(pieces->of.size()), b);
            pieces->of.push_back(cut.of);
            pieces->stopped.push_back(cut.piece.fate == BeamPiece::Fate::stopped);
        }
    return pieces;
}

}  // namespace waterlight
