#include "caustics/beam_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "caustics/kernels/beams.hpp"
#include "caustics/kernels/optics.hpp"

namespace waterlight {

namespace {

struct Base {
    std::array<glm::dvec3, 3> corner, light;  ///< light advances by one metre of descent
    std::array<double, 3> end_z{0, 0, 0};
    double path = 0;
};

Base base_of(const Beams& b, int beam, int row) {
    Base base;
    const std::array<glm::ivec2, 3> at = corners_of(beam, row);
    for (int k = 0; k < 3; ++k) {
        const int i = at[k].x, j = at[k].y;
        base.corner[k] = {b.x(i, j), b.y(i, j), b.z(i, j)};
        base.light[k] = {b.travel_x(i, j), b.travel_y(i, j), -1};
        base.end_z[k] = b.end_z(i, j);
        base.path += b.path(i, j) / 3;
    }
    return base;
}

/// Moves a place by whole periods, next to the beam at its depth.
glm::dvec3 beside(const Beams& b, const Base& base, glm::dvec3 place) {
    const Side sides[2] = {b.boundary.x, b.boundary.y};
    const double period[2] = {b.domain.width_m(), b.domain.height_m()};
    for (int axis = 0; axis < 2; ++axis) {
        if (sides[axis] != Side::periodic) continue;
        const double there = base.corner[0][axis] + (base.corner[0].z - place.z) * base.light[0][axis];
        place[axis] += period[axis] * std::round((there - place[axis]) / period[axis]);
    }
    return place;
}

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

/// Whether the section's triangle (corners d, d + 1, d + 2 about the origin) holds the origin.
bool holds_origin(glm::dvec2 p0, glm::dvec2 p1, glm::dvec2 p2) {
    const double a = cross(p0, p1), b = cross(p1, p2), c = cross(p2, p0);
    return (a >= 0 && b >= 0 && c >= 0) || (a < 0 && b < 0 && c < 0);
}

/// Where the light ends whose ray is at the origin of the section's triangle: linear between the corners.
double end_at_origin(const Base& base, glm::dvec2 p0, glm::dvec2 p1, glm::dvec2 p2) {
    const double a = cross(p1, p2), b = cross(p2, p0), c = cross(p0, p1), sum = a + b + c;
    if (sum == 0) return std::min({base.end_z[0], base.end_z[1], base.end_z[2]});
    return (a * base.end_z[0] + b * base.end_z[1] + c * base.end_z[2]) / sum;
}

bool beyond_walls(const Beams& b, glm::dvec3 p) {
    const Grid& g = b.domain;
    return (b.boundary.x == Side::wall && (p.x < g.x0_m || p.x > g.x0_m + g.width_m())) ||
           (b.boundary.y == Side::wall && (p.y < g.y0_m || p.y > g.y0_m + g.height_m()));
}

/// A place on the edge between two beams would be in both, or by rounding in none: it is read a millionth of the grid's
/// pitch beside it, towards the middle of the domain.
glm::dvec3 off_edges(const Beams& b, glm::dvec3 place) {
    constexpr double hair = 1e-6;
    const Grid& g = b.domain;
    const double x = place.x > g.x0_m + 0.5 * g.width_m() ? -0.618 : 0.618;
    const double y = place.y > g.y0_m + 0.5 * g.height_m() ? -0.755 : 0.755;
    return place + hair * glm::dvec3{x * g.width_m() / b.nx, y * g.height_m() / b.ny, 0};
}

/// Adds what these beams bring to a place; where they end is asked where it is not the floor everywhere.
void add_beams(const Beams& beams, glm::dvec3 place_m, bool uneven, PointIrradiance& sum) {
    for (int j = 0; j < beams.ny; ++j) {
        for (int beam = 0; beam < 2 * beams.nx; ++beam) {
            const double flux = beams.flux(beam, j);
            if (!(flux > 0)) continue;
            const Base base = base_of(beams, beam, j);
            const glm::dvec3 place = beside(beams, base, place_m);
            const f64::BeamSpace space = f64::beam_space(base.corner[0], base.corner[1], base.corner[2], base.light[0],
                                                         base.light[1], base.light[2]);
            const double y = glm::dot(space.y, place - space.origin);
            if (y < 0) continue;
            const glm::dvec2 p0 = y * space.d0 - f64::place_in(space, place);
            const glm::dvec2 p1 = p0 + space.k1 + y * space.l1, p2 = p0 + space.k2 + y * space.l2;
            if (!holds_origin(p0, p1, p2)) continue;
            constexpr double hair_m = 1e-5;  // heights are floats
            if (uneven && place.z < end_at_origin(base, p0, p1, p2) - hair_m) continue;
            const double cosine = 1 / std::sqrt(1 + glm::dot(space.d0, space.d0));
            const double way = y / cosine;
            const double across = f64::irradiance_across(flux, f64::section_area(space.area, y), cosine) *
                                  f64::beer_lambert(beams.extinction_per_m, way);
            sum.scalar_w_m2 += across;
            sum.plane_w_m2 += across / base.path;
            ++sum.beams;
        }
    }
}

}  // namespace

PointIrradiance irradiance_at(const Beams& beams, glm::dvec3 at_m) {
    PointIrradiance sum;
    if (beyond_walls(beams, at_m)) return sum;
    const glm::dvec3 place_m = off_edges(beams, at_m);
    add_beams(beams, place_m, beams.ground != nullptr, sum);
    if (beams.pieces) add_beams(beams.pieces->beams, place_m, true, sum);
    return sum;
}

}  // namespace waterlight
