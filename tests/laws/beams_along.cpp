// Pictures that look against the light: rays that run along the beams.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "caustics/beam_image.hpp"
#include "caustics/kernels/beams.hpp"
#include "caustics/kernels/optics.hpp"
#include "caustics/kernels/phase.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight {
namespace {

using namespace test;
using glm::dvec2;
using glm::dvec3;

/// The edges of a cell that a ray runs along, and how the ray passes them.
struct Cell {
    f64::BeamEdge edge[4];  // travel less the mean
    dvec2 v;
    double down = .9;

    f64::CellSides sides(double t) const {
        dvec2 u[4];
        for (int k = 0; k < 4; ++k) u[k] = f64::beside_ray(edge[k].at, edge[k].travel, v, down, t);
        return f64::cell_sides(u[0], u[1], u[2], u[3]);
    }
    f64::CellSides bends() const {
        dvec2 u[4];
        for (int k = 0; k < 4; ++k) u[k] = f64::edge_speed(edge[k].travel, v, down);
        return f64::cell_sides(u[0], u[1], u[2], u[3]);
    }
};

Cell random_cell(std::mt19937& random, double off) {
    std::uniform_real_distribution<double> any(-1, 1);
    const dvec2 square[4] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, place{any(random), any(random)};
    Cell c;
    for (int k = 0; k < 4; ++k)
        c.edge[k] = {place + square[k] + .3 * dvec2{any(random), any(random)}, off * dvec2{any(random), any(random)}};
    c.v = .5 * dvec2{any(random), any(random)};
    return c;
}

/// What of t from 0 to 2 is in the cell's first beam, over twice the area of the section there, from sums over places.
double by_places(const Cell& c, int places) {
    double sum = 0;
    for (int k = 0; k < places; ++k) {
        const f64::CellSides s = c.sides(2 * (k + .5) / places);
        const bool left = s.s01 > 0 && s.s12 > 0 && s.s20 > 0, right = s.s01 < 0 && s.s12 < 0 && s.s20 < 0;
        if (left || right) sum += 2.0 / places / std::abs(s.s01 + s.s12 + s.s20);
    }
    return sum;
}

double by_parts(const Cell& c, int parts) {
    double sum = 0;
    for (int k = 0; k < parts; ++k) {
        const double step = 2.0 / parts, begin = k * step;
        const f64::CellSides a = c.sides(begin), b = c.sides(begin + step);
        const f64::CellSides bend = c.bends();
        sum += f64::density_in_part({0, 2}, begin, step, {a.s01, b.s01, step * step * bend.s01},
                                    {a.s12, b.s12, step * step * bend.s12}, {a.s20, b.s20, step * step * bend.s20});
    }
    return sum;
}

TEST(BeamsAlong, InParallelBeamsOnePartIsExact) {
    std::mt19937 random(8);
    int met = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const Cell c = random_cell(random, 0);
        const double expected = by_places(c, 20000);
        EXPECT_NEAR(by_parts(c, 1), expected, 3e-4);
        EXPECT_NEAR(by_parts(c, 7), expected, 3e-4);
        met += expected > 0 ? 1 : 0;
    }
    EXPECT_GT(met, 50);
}

TEST(BeamsAlong, InWarpedBeamsMorePartsConverge) {
    std::mt19937 random(9);
    double last = 1e9;
    for (const int parts : {4, 16, 64}) {
        random.seed(9);
        double error = 0, sum = 0;
        for (int trial = 0; trial < 200; ++trial) {
            const Cell c = random_cell(random, .3);
            const double expected = by_places(c, 20000);
            error += std::abs(by_parts(c, parts) - expected);
            sum += expected;
        }
        EXPECT_LT(error, 0.3 * last) << parts;
        last = error;
        if (parts == 64) {
            EXPECT_LT(error, 2e-3 * sum);
        }
    }
}

double cross(dvec2 a, dvec2 b) { return a.x * b.y - a.y * b.x; }

/// What a beam brings to planes that face it, through its horizontal section at a place: 0 where that passes by.
double through_section(const Beams& beams, glm::ivec2 cell, int beam, dvec3 place) {
    const glm::ivec2 around[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    dvec2 u[4];
    double path = 0, above = 0;
    dvec3 corner[4];
    for (int k = 0; k < 4; ++k) {
        const glm::ivec2 c = cell + around[k];
        corner[k] = {beams.x(c.x, c.y), beams.y(c.x, c.y), beams.z(c.x, c.y)};
        u[k] = dvec2(corner[k] - place) +
               (corner[k].z - place.z) * dvec2{beams.travel_x(c.x, c.y), beams.travel_y(c.x, c.y)};
        path += .25 * beams.path(c.x, c.y);
        above += .25 * (corner[k].z - place.z);
    }
    const int b = 1 + beam, c = 2 + beam;
    const double s0 = cross(u[0], u[b]), s1 = cross(u[b], u[c]), s2 = cross(u[c], u[0]);
    const dvec3 lid = glm::cross(corner[b] - corner[0], corner[c] - corner[0]);
    if (glm::dot(lid, place - corner[0]) > 0) return 0;
    if (!(s0 > 0 && s1 > 0 && s2 > 0) && !(s0 < 0 && s1 < 0 && s2 < 0)) return 0;
    return f64::irradiance_across(beams.flux(2 * cell.x + beam, cell.y), std::abs(s0 + s1 + s2), 1 / path) *
           std::exp(-beams.extinction_per_m * path * above);
}

double across_at(const Beams& beams, dvec3 place) {
    double sum = 0;
    for (int j = 0; j < beams.ny; ++j)
        for (int i = 0; i < beams.nx; ++i)
            for (int beam = 0; beam < 2; ++beam) sum += through_section(beams, {i, j}, beam, place);
    return sum;
}

/// Light under or over waves of a pool that goes on, seen against it; scattered evenly, so that only the beams count.
struct Towards {
    Beams beams;
    BeamImageSettings image;

    explicit Towards(bool reflected, int samples) {
        const Boundary open{Side::absorbing, Side::absorbing};
        const Surface surface = sample(make_grid(128, 128, 4, 4), open, sines({{.008, 1, 20}, {.005, .75, 100}}));
        BeamSettings s;
        s.grid = {24, 24};
        s.depth_m = reflected ? 1 : 2;
        s.sun = {55, 30, 1};
        s.optics.absorption_per_m = .05;
        s.optics.scattering_per_m = .1;
        s.optics.phase.g = 0;
        image.optics = s.optics;
        image.samples = samples;
        const dvec3 sun = s.sun.direction();
        if (reflected) {
            make_reflected_beams(s, surface, beams);
            const dvec3 eye{1.9, 2.2, .8};
            image.camera = mirrored(Camera{eye, eye - dvec3{sun.x, sun.y, -sun.z}, 30, {60, 40}});
        } else {
            make_beams(s, surface, beams);
            const dvec3 eye{1.9, 2.2, -1.7};
            const f64::Refraction rest = f64::refract_sun(sun, {0, 0}, 4.0 / 3, 1);
            image.camera = {eye, eye + dvec3{-rest.travel, 1}, 30, {60, 40}};
        }
    }

    /// What a ray gathers, by sums over places on its way up to the highest crest.
    double by_places(int i, int j, int places) const {
        const dvec3 eye = image.camera.position_m, r = image.camera.rays().at(i, j);
        const double far = (beams.highest_m - eye.z) / r.z, step = glm::length(r) * far / places;
        double sum = 0;
        for (int k = 0; k < places; ++k) {
            const double way = (k + .5) * step;
            sum += across_at(beams, eye + way / glm::length(r) * r) * std::exp(-beams.extinction_per_m * way) * step;
        }
        return .1 * f64::henyey_greenstein(0, 1) * sum;
    }
};

TEST(BeamsAlong, APictureIsTheSumOverPlacesOnItsRays) {
    for (const bool reflected : {false, true})
        for (const int samples : {1, 8}) {
            const Towards scene(reflected, samples);
            BeamImage out;
            draw_beams(scene.image, scene.beams, out);
            double difference = 0, square = 0;
            for (int i = 2; i < 60; i += 8)
                for (int j = 2; j < 40; j += 6) {
                    const double expected = scene.by_places(i, j, 200);
                    difference += std::pow(out.radiance(i, j) - expected, 2);
                    square += expected * expected;
                }
            const double error = std::sqrt(difference / square);
            RecordProperty(
                std::string("rmse_percent_") + (reflected ? "reflected_" : "refracted_") + std::to_string(samples),
                std::to_string(100 * error));
            EXPECT_LT(error, 0.01) << reflected << " " << samples;
        }
}

}  // namespace
}  // namespace waterlight
