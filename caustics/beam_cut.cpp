#include "caustics/beam_cut.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "caustics/cut_triangle.hpp"

namespace waterlight {

namespace {

using Fate = BeamPiece::Fate;

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

// Sizes of triangles, as parts of the least width of the shadow of the object beside which they are.
constexpr double beside = 1.0 / 8;      ///< where no ray shows yet whether the shadow reaches into the triangle
constexpr double finest = 1.0 / 64;     ///< no smaller at the shadow's edge
constexpr double off_edge = 1.0 / 5e3;  ///< by which the edge may be off: of a ball 0.05 % of its shadow
constexpr double finest_bent = 1.0 / 32;
constexpr double off_height = 1.0 / 250;  ///< by which the heights may be where light is stopped

/// A ray of a beam, by shares of the ways from the first corner of its triangle to the others, and what it meets.
struct Sample {
    glm::dvec2 at{0, 0};
    BeamCorner corner;  ///< ends at the object that stops it, if one does
    Fate fate = Fate::goes_on;
    int object = -1;  ///< that stops it, in the water or above
};

using Samples = std::array<Sample, 3>;

/// An object that the light of a beam passes near by, on its way in the water or above.
struct Near {
    int object;
    bool above;
    double width_m = 1;   ///< the least of its shadow
    double beside_m = 1;  ///< size of triangles
    bool convex = true;   ///< rays between two that it stops are stopped
};

/// How large a triangle is beside the objects that it is near.
struct Closeness {
    double widths = 0;  ///< of the narrowest shadow
    double steps = 0;   ///< over the size beside
    double least_width_m = std::numeric_limits<double>::infinity();
    bool convex = true;
};

/// The work on one beam.
class Cut {
  public:
    Cut(const BeamCutter::World& world, const BeamTriangle& beam) : world_(world), beam_(beam) {
        Samples whole;
        for (int k = 0; k < 3; ++k) whole[k] = {CutTriangle::corners[k], beam[k], Fate::goes_on, -1};
        find_near(whole);
        if (near_.empty()) return;
        for (Sample& s : whole) s = sample(s.at);
        refine(whole, 0);
        if (pieces_.size() == 1 && pieces_[0].fate == Fate::goes_on) pieces_.clear();
    }

    std::vector<BeamPiece> take() { return std::move(pieces_); }

  private:
    /// From the beams' frame to the world's, and back.
    glm::dvec3 flipped(glm::dvec3 v) const { return world_.beams.mirrored ? glm::dvec3{v.x, v.y, -v.z} : v; }

    void find_near(const Samples& whole) {
        for (int k = 0; k < world_.objects.placed().count(); ++k)
            for (const bool above : {false, true})
                if (size_beside(whole, k, above) > 0) near_.push_back(near(k, above));
    }

    Near near(int object, bool above) const {
        const Shape& shape = world_.objects.placed().object(object).shape;
        const glm::dvec3 way = above ? world_.to_sun : flipped({mean_travel(beam_), -1});
        Near n{object, above};
        n.width_m = world_.boxes[static_cast<std::size_t>(object)].least_width_m(glm::dvec2(way) / way.z);
        n.beside_m = beside * n.width_m;
        if (const auto* ring = std::get_if<Ring>(&shape))
            n.beside_m = std::min(n.beside_m, (ring->outer_radius_m - ring->inner_radius_m) / 1.5);
        n.convex = !std::holds_alternative<Ring>(shape) && !std::holds_alternative<Mesh>(shape);
        return n;
    }

    static glm::dvec2 mean_travel(const BeamTriangle& corners) {
        return (corners[0].travel + corners[1].travel + corners[2].travel) / 3.0;
    }

    /// The longest side of a triangle where its light comes to an object's height; 0 where it passes by.
    double size_beside(const Samples& triangle, int object, bool above) const {
        const double bottom = world_.objects.placed().low_m(object).z, top = world_.objects.placed().high_m(object).z;
        std::array<glm::dvec2, 3> nearer, farther, middle;
        bool comes = false;
        glm::dvec2 low(std::numeric_limits<double>::max()), high = -low, lean{0, 0};
        const ShadowBox& box = world_.boxes[static_cast<std::size_t>(object)];
        for (int k = 0; k < 3; ++k) {
            const BeamCorner& c = triangle[k].corner;
            const glm::dvec3 from = flipped(c.at_m), way = above ? world_.to_sun : flipped({c.travel, -1});
            const double end = above ? top : flipped({0, 0, end_at(triangle[k].at)}).z;
            const double first = std::min(from.z, end), last = std::max(from.z, end);
            comes = comes || (bottom <= last && top >= first && (!above || top > from.z));
            const glm::dvec2 leans = glm::dvec2(way) / way.z;
            const auto at = [&](double z) { return glm::dvec2(from) + (z - from.z) * leans; };
            nearer[k] = at(std::clamp(bottom, first, last));
            farther[k] = at(std::clamp(top, first, last));
            middle[k] = at(box.middle_m.z);
            lean += leans / 3.0;
            low = glm::min(low, glm::min(nearer[k], farther[k]));
            high = glm::max(high, glm::max(nearer[k], farther[k]));
        }
        if (!comes || !shadow_meets(object, {low, high}, middle, lean, triangle)) return 0;
        double size = std::numeric_limits<double>::min();
        for (int k = 0; k < 3; ++k) {
            const int n = (k + 1) % 3;
            size = std::max({size, glm::distance(nearer[k], nearer[n]), glm::distance(farther[k], farther[n])});
        }
        return size;
    }

    /// Whether the shadow of an object's box meets a triangle at the box's height, from any period.
    bool shadow_meets(int object, const std::array<glm::dvec2, 2>& reach, const std::array<glm::dvec2, 3>& middle,
                      glm::dvec2 lean, const Samples& triangle) const {
        const RepeatedObjects::Shifts shifts = world_.objects.shifts(object, reach[0], reach[1]);
        const ShadowBox& box = world_.boxes[static_cast<std::size_t>(object)];
        // Rays of a beam lean differently: by so much the shadow may be off.
        double spread = 0;
        for (int k = 0; k < 3; ++k)
            spread = std::max(spread, glm::distance(triangle[k].corner.travel, triangle[(k + 1) % 3].corner.travel));
        const double half_height =
            0.5 * (world_.objects.placed().high_m(object).z - world_.objects.placed().low_m(object).z);
        for (int q = shifts.first.y; q <= shifts.last.y; ++q)
            for (int p = shifts.first.x; p <= shifts.last.x; ++p)
                if (box.meets(middle, lean, glm::dvec2{p, q} * world_.objects.period_m(), spread * half_height))
                    return true;
        return false;
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
        const Grid& g = world_.beams.domain;
        const glm::dvec2 low{g.x0_m, g.y0_m}, high = low + glm::dvec2{g.width_m(), g.height_m()};
        double way = std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 2; ++axis) {
            const double speed = ray.direction[axis];
            if ((axis == 0 ? world_.beams.boundary.x : world_.beams.boundary.y) != Side::wall || speed == 0) continue;
            way = std::min(way, std::max(0.0, ((speed > 0 ? high : low)[axis] - ray.from_m[axis]) / speed));
        }
        return way;
    }

    Sample sample(glm::dvec2 at) const {
        Sample s{at, between(at), Fate::goes_on, -1};
        const glm::dvec3 from = flipped(s.corner.at_m);
        if (const auto hit = world_.objects.first_hit({.from_m = from, .direction = world_.to_sun})) {
            s.fate = Fate::shaded;
            s.object = hit->object;
            return s;
        }
        const glm::dvec3 way = flipped({s.corner.travel, -1});
        const double length = glm::length(way);
        Ray ray{.from_m = from, .direction = way / length};
        ray.farthest_m = std::min(s.corner.depth_m() * length, to_wall(ray));
        if (const auto hit = world_.objects.first_hit(ray)) {
            s.fate = Fate::stopped;
            s.object = hit->object;
            s.corner.end_z = s.corner.at_m.z - hit->distance_m / length;
        }
        return s;
    }

    Closeness closeness(const Samples& t) const {
        Closeness c;
        for (const Near& near : near_) {
            const double size = size_beside(t, near.object, near.above);
            if (!(size > 0)) continue;
            c.widths = std::max(c.widths, size / near.width_m);
            c.steps = std::max(c.steps, size / near.beside_m);
            c.least_width_m = std::min(c.least_width_m, near.width_m);
            c.convex = c.convex && near.convex;
        }
        return c;
    }

    static bool same_fate(const Sample& a, const Sample& b) { return a.fate == b.fate; }
    static bool mixed(const Samples& t) { return !same_fate(t[0], t[1]) || !same_fate(t[0], t[2]); }

    /// Halves a triangle until it is small enough beside what its light passes, then keeps it or cuts it.
    void refine(const Samples& t, int level) {
        constexpr int deepest = 16;
        if (level < deepest && !is_fine(t, closeness(t))) return halve(t, level);
        if (!mixed(t)) return keep(t, t[0].fate);
        cut(t, {Fate::shaded, Fate::stopped}, level);
    }

    bool is_fine(const Samples& t, const Closeness& c) const {
        if (mixed(t)) return c.steps <= 1 && (c.widths <= finest || is_straight(t, c.widths));
        if (t[0].fate == Fate::goes_on) return c.steps <= 1;
        const bool one = t[0].object == t[1].object && t[0].object == t[2].object;
        const bool holds = one && c.convex ? c.widths <= 1 : c.steps <= 1;
        return holds && (c.widths <= finest_bent || !is_bent(t, c.least_width_m));
    }

    /// Whether what stops the light in the middle of a triangle is not where its corners say.
    bool is_bent(const Samples& t, double width_m) const {
        const Sample middle = sample((t[0].at + t[1].at + t[2].at) / 3.0);
        if (!same_fate(middle, t[0])) return true;
        const double plane = (t[0].corner.end_z + t[1].corner.end_z + t[2].corner.end_z) / 3;
        return middle.fate == Fate::stopped && std::abs(middle.corner.end_z - plane) > off_height * width_m;
    }

    /// Whether the edge of a shadow passes through a triangle in a straight line, as far as its middle shows. `widths`
    /// is the triangle's size.
    bool is_straight(const Samples& t, double widths) const {
        int lone = 0;
        while (same_fate(t[(lone + 1) % 3], t[lone]) || same_fate(t[(lone + 2) % 3], t[lone]))
            if (++lone == 3) return false;
        const Sample &own = t[lone], &a = t[(lone + 1) % 3], &b = t[(lone + 2) % 3];
        if (!same_fate(a, b)) return false;
        constexpr int halvings = 12;
        const glm::dvec2 middle = 0.5 * (edge_between(own, a, own.fate, halvings).first.at +
                                         edge_between(own, b, own.fate, halvings).first.at);
        const double side =
            std::max({glm::distance(own.at, a.at), glm::distance(a.at, b.at), glm::distance(b.at, own.at)});
        const double away = glm::distance(middle, own.at) / side * widths;  // of the corner, in widths
        if (away <= off_edge) return true;
        const glm::dvec2 off = off_edge / away * (own.at - middle);
        return same_fate(sample(middle + off), own) && same_fate(sample(middle - off), a);
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
        for (int k = 0; k < 3; ++k) piece.corner[k] = t[k].corner;
        pieces_.push_back(piece);
    }

    struct Polygon {
        std::array<Sample, 4> corner;
        int count = 0;
        void add(const Sample& s) { corner[count++] = s; }
    };

    /// Cuts off what has the first fate, then of the rest what has the second.
    void cut(const Samples& t, std::array<Fate, 2> fates, int level) {
        Polygon of_it, others;
        for (int k = 0; k < 3; ++k) {
            const Sample &a = t[k], &b = t[(k + 1) % 3];
            const bool here = a.fate == fates[0], next = b.fate == fates[0];
            (here ? of_it : others).add(a);
            if (here == next) continue;
            const auto [inside, outside] = edge_between(here ? a : b, here ? b : a, fates[0], 22);
            of_it.add(inside);
            others.add(outside);
        }
        for (int k = 1; k + 1 < of_it.count; ++k) {
            const Samples part{of_it.corner[0], of_it.corner[k], of_it.corner[k + 1]};
            // At the edge of a ball what stops the light is steep.
            fates[0] == Fate::stopped ? refine(part, level + 1) : keep(part, fates[0]);
        }
        const bool last = fates[0] == fates[1];
        for (int k = 1; k + 1 < others.count; ++k) {
            const Samples rest{others.corner[0], others.corner[k], others.corner[k + 1]};
            last ? keep(rest, Fate::goes_on) : cut(rest, {fates[1], fates[1]}, level);
        }
    }

    /// The last ray that has the fate on the way from one that has to one that has not, and the first that has not; at
    /// one place, so that what they part has no gap.
    std::pair<Sample, Sample> edge_between(Sample inside, Sample outside, Fate fate, int halvings) const {
        for (int k = 0; k < halvings; ++k) {
            const Sample middle = sample(0.5 * (inside.at + outside.at));
            (middle.fate == fate ? inside : outside) = middle;
        }
        const double end_z = outside.corner.end_z;
        outside.at = inside.at;
        outside.corner = inside.corner;
        outside.corner.end_z = end_z;
        return {inside, outside};
    }

    const BeamCutter::World& world_;
    const BeamTriangle& beam_;
    std::vector<Near> near_;
    std::vector<BeamPiece> pieces_;
};

}  // namespace

BeamCutter::BeamCutter(const BeamSettings& settings, const Beams& beams)
    : world_{beams,
             RepeatedObjects(settings.objects, beams.time_s, beams.domain, beams.boundary),
             {},
             -settings.sun.direction()} {
    for (const Object& object : settings.objects->objects()) world_.boxes.emplace_back(object, beams.time_s);
}

std::vector<BeamPiece> BeamCutter::pieces(const BeamTriangle& beam) const { return Cut(world_, beam).take(); }

}  // namespace waterlight
