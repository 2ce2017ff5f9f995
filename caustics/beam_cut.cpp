#include "caustics/beam_cut.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "caustics/cut_triangle.hpp"
#include "caustics/objects/shape_hits.hpp"

namespace waterlight {

namespace {

using Fate = BeamPiece::Fate;

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

/// The least width of an object's shadow on a level plane, cast by light that goes `lean` metres aside for each metre
/// up: of the shadow of the box about the shape's own axes, a hexagon.
double shadow_width(const Object& object, glm::dvec2 lean) {
    const ShapeBox box = box_of(object.shape);
    const glm::dmat3 turn = object.turn();
    std::array<glm::dvec2, 3> side;
    for (int k = 0; k < 3; ++k) {
        const glm::dvec3 edge = 2 * box.half_m[k] * turn[k];
        side[k] = glm::dvec2(edge) - edge.z * lean;
    }
    double least = std::numeric_limits<double>::infinity();
    for (const glm::dvec2 across : side) {
        const double length = glm::length(across);
        if (length == 0) continue;
        double width = 0;
        for (const glm::dvec2 s : side) width += std::abs(cross(s, across)) / length;
        if (width > 0) least = std::min(least, width);
    }
    return least;
}

/// How small triangles must be beside an object: everywhere, so that none of it is missed, and at its shadow's edge.
struct Fineness {
    double everywhere_m, edge_m;
    Fineness(const Object& object, glm::dvec2 lean) {
        const double width = shadow_width(object, lean);
        // A chord across h of a ball's edge leaves (h / R)^2 / 6 of its shadow: at h = width / 32 less than 0.1 %.
        everywhere_m = width / 8;
        edge_m = width / 32;
        if (const auto* ring = std::get_if<Ring>(&object.shape))
            everywhere_m = std::min(everywhere_m, (ring->outer_radius_m - ring->inner_radius_m) / 1.5);
        edge_m = std::min(edge_m, everywhere_m);
    }
};

/// A ray of a beam, by shares of the ways from the first corner of its triangle to the others, and what it meets.
struct Sample {
    glm::dvec2 at{0, 0};
    BeamCorner corner;  ///< ends at the object that stops it, if one does
    Fate fate = Fate::goes_on;
};

using Samples = std::array<Sample, 3>;

/// An object that the light of a beam passes near by, on its way in the water or above.
struct Near {
    int object;
    bool above;
    Fineness fineness;
};

/// The work on one beam.
class Cut {
  public:
    Cut(const Beams& beams, const RepeatedObjects& objects, glm::dvec3 to_sun, const BeamTriangle& beam)
        : beams_(beams), objects_(objects), to_sun_(to_sun), beam_(beam) {
        Samples whole;
        for (int k = 0; k < 3; ++k) whole[k] = {CutTriangle::corners[k], beam[k], Fate::goes_on};
        find_near(whole);
        if (near_.empty()) return;
        for (Sample& s : whole) s = sample(s.at);
        refine(whole, 0);
        if (pieces_.size() == 1 && pieces_[0].fate == Fate::goes_on) pieces_.clear();
    }

    std::vector<BeamPiece> take() { return std::move(pieces_); }

  private:
    /// From the beams' frame to the world's, and back.
    glm::dvec3 flipped(glm::dvec3 v) const { return beams_.mirrored ? glm::dvec3{v.x, v.y, -v.z} : v; }

    void find_near(const Samples& whole) {
        glm::dvec2 travel{0, 0};
        for (const BeamCorner& c : beam_) travel += c.travel / 3.0;
        const glm::dvec3 light = flipped({travel, -1});
        for (int k = 0; k < objects_.placed().count(); ++k)
            for (const bool above : {false, true}) {
                const glm::dvec3 way = above ? to_sun_ : light;
                const Near near{k, above, {objects_.placed().object(k), glm::dvec2(way) / way.z}};
                if (size_beside(whole, near) > 0) near_.push_back(near);
            }
    }

    /// The longest side of a triangle where its light comes to an object's height; 0 where it passes by.
    double size_beside(const Samples& triangle, const Near& near) const {
        const double bottom = objects_.placed().low_m(near.object).z, top = objects_.placed().high_m(near.object).z;
        std::array<glm::dvec2, 3> nearer, farther;
        glm::dvec2 low(std::numeric_limits<double>::max()), high = -low;
        bool met = false;
        for (int k = 0; k < 3; ++k) {
            const BeamCorner& c = triangle[k].corner;
            const glm::dvec3 from = flipped(c.at_m), way = near.above ? to_sun_ : flipped({c.travel, -1});
            const double end =
                near.above ? std::numeric_limits<double>::infinity() : flipped({0, 0, end_at(triangle[k].at)}).z;
            const double first = std::min(from.z, end), last = std::max(from.z, end);
            const double z0 = std::clamp(bottom, first, last), z1 = std::clamp(top, first, last);
            met = met || (bottom <= last && top >= first);
            nearer[k] = glm::dvec2(from) + (z0 - from.z) / way.z * glm::dvec2(way);
            farther[k] = glm::dvec2(from) + (z1 - from.z) / way.z * glm::dvec2(way);
            low = glm::min(low, glm::min(nearer[k], farther[k]));
            high = glm::max(high, glm::max(nearer[k], farther[k]));
        }
        if (!met || !objects_.over(near.object, low, high)) return 0;
        double size = std::numeric_limits<double>::min();
        for (int k = 0; k < 3; ++k) {
            const int n = (k + 1) % 3;
            size = std::max({size, glm::distance(nearer[k], nearer[n]), glm::distance(farther[k], farther[n])});
        }
        return size;
    }

    /// Where light would end without objects.
    double end_at(glm::dvec2 at) const {
        return beam_[0].end_z + at.x * (beam_[1].end_z - beam_[0].end_z) + at.y * (beam_[2].end_z - beam_[0].end_z);
    }

    /// A ray of the beam between its corners: where it passes at z = 0, and its travel, are linear between theirs, so
    /// that pieces fill every level section of the beam.
    BeamCorner between(glm::dvec2 at) const {
        const auto mix = [at](auto a, auto b, auto c) { return a + at.x * (b - a) + at.y * (c - a); };
        const auto [a, b, c] = beam_;
        const auto still = [](const BeamCorner& k) { return glm::dvec2(k.at_m) + k.at_m.z * k.travel; };
        BeamCorner corner;
        corner.travel = mix(a.travel, b.travel, c.travel);
        corner.at_m.z = mix(a.at_m.z, b.at_m.z, c.at_m.z);
        const glm::dvec2 place = mix(still(a), still(b), still(c)) - corner.at_m.z * corner.travel;
        corner.at_m = {place, corner.at_m.z};
        corner.path = mix(a.path, b.path, c.path);
        corner.end_z = mix(a.end_z, b.end_z, c.end_z);
        corner.transmittance = mix(a.transmittance, b.transmittance, c.transmittance);
        return corner;
    }

    /// How far a ray goes to the first wall.
    double to_wall(const Ray& ray) const {
        const Grid& g = beams_.domain;
        const glm::dvec2 low{g.x0_m, g.y0_m}, high = low + glm::dvec2{g.width_m(), g.height_m()};
        double way = std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 2; ++axis) {
            const double speed = ray.direction[axis];
            if ((axis == 0 ? beams_.boundary.x : beams_.boundary.y) != Side::wall || speed == 0) continue;
            way = std::min(way, std::max(0.0, ((speed > 0 ? high : low)[axis] - ray.from_m[axis]) / speed));
        }
        return way;
    }

    Sample sample(glm::dvec2 at) const {
        Sample s{at, between(at), Fate::goes_on};
        const glm::dvec3 from = flipped(s.corner.at_m);
        if (objects_.first_hit({.from_m = from, .direction = to_sun_})) {
            s.fate = Fate::shaded;
            return s;
        }
        const glm::dvec3 way = flipped({s.corner.travel, -1});
        const double length = glm::length(way);
        Ray ray{.from_m = from, .direction = way / length};
        ray.farthest_m = std::min(s.corner.depth_m() * length, to_wall(ray));
        if (const auto hit = objects_.first_hit(ray)) {
            s.fate = Fate::stopped;
            s.corner.end_z = s.corner.at_m.z - hit->distance_m / length;
        }
        return s;
    }

    /// Halves a triangle until it is small beside what its light passes, then keeps it or cuts it.
    void refine(const Samples& t, int level) {
        constexpr int deepest = 14;
        double everywhere = 0, edge = 0;
        for (const Near& near : near_) {
            const double size = size_beside(t, near);
            everywhere = std::max(everywhere, size / near.fineness.everywhere_m);
            edge = std::max(edge, size / near.fineness.edge_m);
        }
        const bool mixed = t[0].fate != t[1].fate || t[0].fate != t[2].fate;
        if ((everywhere > 1 || (mixed && edge > 1)) && level < deepest) return halve(t, level);
        if (!mixed) return keep(t, t[0].fate);
        cut(t, {Fate::shaded, Fate::stopped});
    }

    void halve(const Samples& t, int level) {
        const std::size_t before = pieces_.size();
        const auto middle = [&](int a, int b) { return sample(0.5 * (t[a].at + t[b].at)); };
        const Sample m01 = middle(0, 1), m12 = middle(1, 2), m20 = middle(2, 0);
        refine({t[0], m01, m20}, level + 1);
        refine({m01, t[1], m12}, level + 1);
        refine({m20, m12, t[2]}, level + 1);
        refine({m12, m20, m01}, level + 1);
        // Quarters that light passes freely are one piece.
        const auto free = [](const BeamPiece& p) { return p.fate == Fate::goes_on; };
        const double share = std::abs(cross(t[1].at - t[0].at, t[2].at - t[0].at));
        if (pieces_.size() != before + 4 ||
            !std::all_of(pieces_.begin() + static_cast<std::ptrdiff_t>(before), pieces_.end(), free))
            return;
        // Four free pieces of a triangle that was cut are not its quarters.
        for (std::size_t k = before; k < pieces_.size(); ++k)
            if (std::abs(pieces_[k].share - 0.25 * share) > 1e-12 * share) return;
        pieces_.resize(before);
        keep(t, Fate::goes_on);
    }

    void keep(const Samples& t, Fate fate) {
        BeamPiece piece;
        piece.fate = fate;
        piece.share = std::abs(cross(t[1].at - t[0].at, t[2].at - t[0].at));
        if (!(piece.share > 0)) return;
        for (int k = 0; k < 3; ++k) {
            piece.corner[k] = t[k].corner;
            if (fate == Fate::goes_on) piece.corner[k].end_z = end_at(t[k].at);
        }
        pieces_.push_back(piece);
    }

    struct Polygon {
        std::array<Sample, 4> corner;
        int count = 0;
        void add(const Sample& s) { corner[count++] = s; }
    };

    /// Cuts off what has the first fate, then of the rest what has the second.
    void cut(const Samples& t, std::array<Fate, 2> fates) {
        Polygon of_it, others;
        for (int k = 0; k < 3; ++k) {
            const Sample &a = t[k], &b = t[(k + 1) % 3];
            const bool here = a.fate == fates[0], next = b.fate == fates[0];
            (here ? of_it : others).add(a);
            if (here == next) continue;
            const auto [inside, outside] = edge_between(here ? a : b, here ? b : a, fates[0]);
            of_it.add(inside);
            others.add(outside);
        }
        for (int k = 1; k + 1 < of_it.count; ++k)
            keep({of_it.corner[0], of_it.corner[k], of_it.corner[k + 1]}, fates[0]);
        const bool last = fates[0] == fates[1];
        for (int k = 1; k + 1 < others.count; ++k) {
            const Samples rest{others.corner[0], others.corner[k], others.corner[k + 1]};
            last ? keep(rest, Fate::goes_on) : cut(rest, {fates[1], fates[1]});
        }
    }

    /// The last ray that has the fate on the way from one that has to one that has not, and the first that has not; at
    /// one place, so that what they part has no gap.
    std::pair<Sample, Sample> edge_between(Sample inside, Sample outside, Fate fate) const {
        for (int k = 0; k < 24; ++k) {
            const Sample middle = sample(0.5 * (inside.at + outside.at));
            (middle.fate == fate ? inside : outside) = middle;
        }
        const double end_z = outside.corner.end_z;
        outside.at = inside.at;
        outside.corner = inside.corner;
        outside.corner.end_z = end_z;
        return {inside, outside};
    }

    const Beams& beams_;
    const RepeatedObjects& objects_;
    glm::dvec3 to_sun_;
    const BeamTriangle& beam_;
    std::vector<Near> near_;
    std::vector<BeamPiece> pieces_;
};

}  // namespace

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

BeamCutter::BeamCutter(const BeamSettings& settings, const Beams& beams)
    : beams_(beams),
      objects_(settings.objects, beams.time_s, beams.domain, beams.boundary),
      to_sun_(-settings.sun.direction()) {}

std::vector<BeamPiece> BeamCutter::pieces(const BeamTriangle& beam) const {
    return Cut(beams_, objects_, to_sun_, beam).take();
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
            pieces->stopped.push_back(cut.piece.fate == Fate::stopped);
        }
    return pieces;
}

}  // namespace waterlight
