#include "caustics/beams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "caustics/beam_capture.hpp"
#include "caustics/beam_cut.hpp"
#include "caustics/cut_triangle.hpp"
#include "caustics/kernels/optics.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

void validate(const BeamSettings& s) {
    if (s.grid.x < 1 || s.grid.y < 1)
        throw InputError(fmt::format("beams: the grid is {} x {} cells; at least 1 x 1", s.grid.x, s.grid.y));
    if (s.window && !(s.window->size_m.x > 0 && s.window->size_m.y > 0))
        throw InputError("beams: the window's size must be above 0");
    if (!(s.depth_m > 0 && s.depth_m <= 1e30)) throw InputError("beams: the depth must be above 0, at most 1e30 m");
    if (!(s.sun.irradiance_w_m2 >= 0 && s.sun.irradiance_w_m2 <= 1e30))
        throw InputError("beams: the irradiance must be at least 0, at most 1e30 W/m2");
    if (!(s.optics.refractive_index >= 1)) throw InputError("beams: the refractive index must be at least 1");
    if (!(s.optics.extinction_per_m() >= 0)) throw InputError("beams: absorption and scattering must be at least 0");
    if (!(s.least_cosine >= 0 && s.least_cosine < 1)) throw InputError("beams: least_cosine must be in [0, 1)");
}

/// The way of light behind a point of the surface, by its slope.
struct Bend {
    glm::vec3 sun;
    float index, fresnel;
    bool mirrored;
    Bend(const BeamSettings& s, bool is_mirrored)
        : sun(s.sun.direction()),
          index(static_cast<float>(s.optics.refractive_index)),
          fresnel(s.optics.fresnel ? 1 : 0),
          mirrored(is_mirrored) {}
    f32::Refraction operator()(glm::vec2 slope) const {
        return mirrored ? f32::reflect_sun(sun, slope, index, fresnel) : f32::refract_sun(sun, slope, index, fresnel);
    }
};

/// How far light strays from where still water would send it, per metre of descent: the most of any cell.
double largest_stray(const Bend& bend, glm::vec2 rest, const Surface& surface) {
    float stray = 0;
#pragma omp parallel for schedule(static) reduction(max : stray)
    for (int j = 0; j < surface.grid.ny; ++j) {
        const float *x = surface.slope_x.row(j), *y = surface.slope_y.row(j);
        for (int i = 0; i < surface.grid.nx; ++i) {
            const f32::Refraction r = bend({x[i], y[i]});
            if (r.incident > 0 && r.path > 0) stray = std::max(stray, glm::length(r.travel - rest));
        }
    }
    return stray;
}

/// The least window whose light reaches all of the water below the domain. Light from beyond an absorbing side does.
BeamWindow window_over(const BeamSettings& s, const Beams& beams, const Surface& surface,
                       const SurfaceCapture& capture) {
    const Grid& g = surface.grid;
    const Bend bend(s, beams.mirrored);
    const glm::vec2 rest = bend({0, 0}).travel;
    const double stray = largest_stray(bend, rest, surface);
    const glm::dvec2 rise =
        glm::abs(capture.slant()) * std::max(std::abs(capture.lowest_m()), std::abs(capture.highest_m()));
    glm::dvec2 low{g.x0_m, g.y0_m}, high = low + glm::dvec2{g.width_m(), g.height_m()};
    const Side sides[2] = {surface.boundary.x, surface.boundary.y};
    for (int axis = 0; axis < 2; ++axis) {
        if (sides[axis] == Side::periodic) continue;
        low[axis] -= rise[axis];
        high[axis] += rise[axis];
        if (sides[axis] == Side::wall) continue;
        low[axis] -= beams.depth_m * (std::max(0.0F, rest[axis]) + stray);
        high[axis] += beams.depth_m * (std::max(0.0F, -rest[axis]) + stray);
    }
    return {low, high - low};
}

/// Captures and refracts row j of the corners.
void fill_row(const BeamSettings& s, const SurfaceCapture& capture, const BeamWindow& window, int j, Beams& beams) {
    const Bend bend(s, beams.mirrored);
    const float up = beams.mirrored ? -1 : 1;
    const glm::dvec2 pitch = window.size_m / glm::dvec2(s.grid);
    for (int i = 0; i <= s.grid.x; ++i) {
        const CapturedPoint p = capture.capture(window.origin_m + pitch * glm::dvec2{i, j});
        const f32::Refraction r = bend(glm::vec2(p.slope));
        beams.x(i, j) = static_cast<float>(p.at_m.x);
        beams.y(i, j) = static_cast<float>(p.at_m.y);
        beams.z(i, j) = up * static_cast<float>(p.at_m.z);
        beams.travel_x(i, j) = r.travel.x;
        beams.travel_y(i, j) = r.travel.y;
        beams.path(i, j) = r.path;
        beams.end_z(i, j) = static_cast<float>(s.ground ? s.ground->end_z(p.at_m, glm::dvec2(r.travel)) : -s.depth_m);
        beams.transmittance(i, j) = r.transmittance;
    }
}

bool in_domain(const Beams& b, glm::dvec2 p) {
    const Grid& g = b.domain;
    const bool x = b.boundary.x == Side::periodic || (p.x >= g.x0_m && p.x <= g.x0_m + g.width_m());
    const bool y = b.boundary.y == Side::periodic || (p.y >= g.y0_m && p.y <= g.y0_m + g.height_m());
    return x && y;
}

/// A beam between its triangle and where it ends.
struct BeamWay {
    glm::dvec3 area{0, 0, 0};   ///< of the triangle
    glm::dvec2 landed_m{0, 0};  ///< where its middle lands
    double transmittance = 0;   ///< mean of the corners
    bool leaves = true;         ///< whether its light leaves the surface for good
    double wet = 1;             ///< part of the triangle below which there is water
    double remaining = 0;       ///< at the end of its way, of the flux of the whole triangle: without its dry part's
};

/// Cuts off the part of a beam that is on dry ground, and what its flux loses on ways of these depths.
void cut_dry(const BeamTriangle& corner, double extinction_per_m, double path, BeamWay& way) {
    CutTriangle part;
    for (int k = 0; k < 3; ++k) part.add({CutTriangle::corners[k], {corner[k].depth_m(), 0}});
    part = part.where_positive(0);
    way.wet = part.share();
    way.remaining = part.integral(
        [&](const CutTriangle::Corner& c) { return f64::beer_lambert(extinction_per_m, c.level[0] * path); });
}

BeamWay way_of(const BeamTriangle& corner, double extinction_per_m) {
    BeamWay way;
    double path = 0;
    for (const BeamCorner& c : corner) {
        const double descent = std::max(0.0, c.depth_m());
        way.landed_m += (glm::dvec2(c.at_m) + descent * c.travel) / 3.0;
        way.transmittance += c.transmittance / 3.0;
        way.remaining += f64::beer_lambert(extinction_per_m, descent * c.path) / 3;
        path += c.path / 3.0;
        way.leaves = way.leaves && c.path > 0;
    }
    way.area = 0.5 * glm::cross(corner[1].at_m - corner[0].at_m, corner[2].at_m - corner[0].at_m);
    if (std::ranges::any_of(corner, [](const BeamCorner& c) { return c.depth_m() < 0; }))
        cut_dry(corner, extinction_per_m, path, way);
    return way;
}

/// What comes to a beam, or to a piece of one, and enters there, as if all of it were wet.
struct BeamPower {
    double incident_w = 0, flux_w = 0;
};

/// What becomes of the light of a beam with this way. Light that lands is counted where its middle lands.
void charge(const Beams& beams, const BeamWay& way, const BeamPower& power, BeamPiece::Fate fate, BeamLedger& ledger) {
    ledger.dry_w += power.incident_w * (1 - way.wet);
    if (fate == BeamPiece::Fate::shaded) {
        ledger.objects_w += power.incident_w * way.wet;
        return;
    }
    ledger.reflected_w += (power.incident_w - power.flux_w) * way.wet;
    ledger.extinguished_w += power.flux_w * (way.wet - way.remaining);
    double& landed = fate == BeamPiece::Fate::stopped ? ledger.objects_w
                     : in_domain(beams, way.landed_m) ? ledger.floor_w
                                                      : ledger.outside_w;
    landed += power.flux_w * way.remaining;
}

/// The pieces of beams that are added up row by row.
using CutRow = std::vector<CutBeam>;

/// The flux of each beam of row j, and what becomes of it. Pieces go to `cut`, where there is a cutter.
BeamLedger charge_row(const BeamSettings& s, int j, const std::optional<BeamCutter>& cutter, Beams& beams,
                      CutRow& cut) {
    const glm::dvec3 light = s.sun.direction();
    // In the mirror the light comes from below the surface, and so opposes the normal of a triangle that it meets.
    const glm::dvec3 sun = beams.mirrored ? glm::dvec3{-light.x, -light.y, light.z} : light;
    const double e0 = s.sun.elevation_deg > 0 ? s.sun.irradiance_w_m2 : 0;
    BeamLedger ledger;
    for (int b = 0; b < 2 * beams.nx; ++b) {
        const BeamTriangle triangle = triangle_of(beams, b, j);
        const BeamWay way = way_of(triangle, beams.extinction_per_m);
        const double facing = -glm::dot(sun, way.area), incident = e0 * std::abs(facing);
        const bool discarded = !way.leaves || !(facing > s.least_cosine * glm::length(way.area));
        ledger.incident_w += incident;
        beams.flux(b, j) = 0;
        if (discarded || !(way.wet > 0)) {
            (way.wet > 0 ? ledger.discarded_w : ledger.dry_w) += incident;
            continue;
        }
        const BeamPower power{incident, incident * way.transmittance};
        const std::vector<BeamPiece> pieces = cutter ? cutter->pieces(triangle) : std::vector<BeamPiece>{};
        if (pieces.empty()) {
            beams.flux(b, j) = static_cast<float>(power.flux_w);
            charge(beams, way, power, BeamPiece::Fate::goes_on, ledger);
        }
        for (const BeamPiece& piece : pieces) {
            const BeamPower part{piece.share * power.incident_w, piece.share * power.flux_w};
            charge(beams, way_of(piece.corner, beams.extinction_per_m), part, piece.fate, ledger);
            if (piece.fate != BeamPiece::Fate::shaded) cut.push_back({piece, {b, j}, part.flux_w});
        }
    }
    return ledger;
}

/// Makes beams on the side of the surface that `beams` says.
void fill(const BeamSettings& settings, const Surface& surface, Beams& beams) {
    validate(settings);
    BeamSettings s = settings;
    if (!(s.sun.elevation_deg > 0)) s.sun = {90, 0, 0};
    resize(beams, s.grid);
    beams.domain = surface.grid;
    beams.boundary = surface.boundary;
    beams.depth_m = s.depth_m;
    beams.ground = s.ground;
    if (s.ground && static_cast<float>(s.depth_m) < -s.ground->lowest_m()) beams.depth_m = -s.ground->lowest_m();
    beams.extinction_per_m = s.optics.extinction_per_m();
    beams.time_s = surface.time_s;

    const double reach = s.window ? glm::length(s.window->size_m + glm::abs(s.window->origin_m)) : 0;
    const SurfaceCapture capture(surface, s.sun.direction(), reach);
    const BeamWindow window = s.window.value_or(window_over(s, beams, surface, capture));
    std::optional<BeamCutter> cutter;
    if (s.objects && !s.objects->empty() && settings.sun.elevation_deg > 0) cutter.emplace(s, beams);
    std::vector<BeamLedger> rows(s.grid.y);
    std::vector<CutRow> cut(s.grid.y);
#pragma omp parallel
    {
#pragma omp for schedule(static)
        for (int j = 0; j <= s.grid.y; ++j) fill_row(s, capture, window, j, beams);
#pragma omp for schedule(dynamic, 1)
        for (int j = 0; j < s.grid.y; ++j) rows[j] = charge_row(s, j, cutter, beams, cut[j]);
    }
    beams.ledger = {};
    for (const BeamLedger& row : rows) beams.ledger = beams.ledger + row;
    const auto [low, high] = std::minmax_element(beams.z.values().begin(), beams.z.values().end());
    beams.lowest_m = *low;
    beams.highest_m = *high;
    beams.pieces = gather(beams, cut);
}

}  // namespace

void resize(Beams& beams, glm::ivec2 grid) {
    if (beams.nx == grid.x && beams.ny == grid.y) return;
    beams.nx = grid.x;
    beams.ny = grid.y;
    for (Field<float>* f : {&beams.x, &beams.y, &beams.z, &beams.travel_x, &beams.travel_y, &beams.path, &beams.end_z,
                            &beams.transmittance})
        *f = Field<float>(grid.x + 1, grid.y + 1);
    beams.flux = Field<float>(2 * grid.x, grid.y);
}

BeamLedger operator+(BeamLedger a, const BeamLedger& b) {
    a.incident_w += b.incident_w;
    a.reflected_w += b.reflected_w;
    a.extinguished_w += b.extinguished_w;
    a.floor_w += b.floor_w;
    a.outside_w += b.outside_w;
    a.objects_w += b.objects_w;
    a.discarded_w += b.discarded_w;
    a.dry_w += b.dry_w;
    return a;
}

double BeamLedger::closure() const {
    const double accounted = reflected_w + extinguished_w + floor_w + outside_w + discarded_w + dry_w + objects_w;
    return incident_w > 0 ? std::abs(incident_w - accounted) / incident_w : 0;
}

void make_beams(const BeamSettings& settings, const Surface& surface, Beams& beams) {
    beams.mirrored = false;
    fill(settings, surface, beams);
}

void make_reflected_beams(const BeamSettings& settings, const Surface& surface, Beams& beams) {
    BeamSettings s = settings;
    s.ground = nullptr;
    beams.mirrored = true;
    fill(s, surface, beams);
}

}  // namespace waterlight
