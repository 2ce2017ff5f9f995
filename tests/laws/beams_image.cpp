// Pictures of scattered light: closed forms in flat water, no pattern of the grid, and convergence past the focus.
#include <gtest/gtest.h>

#include <algorithm>

#include "caustics/beam_image.hpp"
#include "caustics/beam_point.hpp"
#include "caustics/beam_refine.hpp"
#include "caustics/kernels/optics.hpp"
#include "caustics/kernels/phase.hpp"
#include "tests/support/sides.hpp"
#include "tests/support/surfaces.hpp"

namespace waterlight {
namespace {

using namespace test;

/// Flat water 10 m long between walls, b = .05, c = .15, Henyey & Greenstein g = .9, E0 = 1.
struct FlatPool {
    Beams beams;
    BeamImageSettings image;
    double elevation_deg, azimuth_deg;

    FlatPool(glm::ivec2 grid, double elevation, double azimuth, Boundary boundary = walls)
        : elevation_deg(elevation), azimuth_deg(azimuth) {
        const Surface surface = sample(make_grid(40, 40, 10, 10), boundary, flat);
        BeamSettings s;
        s.grid = grid;
        s.depth_m = 4;
        s.sun = {elevation, azimuth, 1};
        s.optics.absorption_per_m = .1;
        s.optics.scattering_per_m = .05;
        make_beams(s, surface, beams);
        image.optics = s.optics;
        image.camera.size = {90, 60};
    }

    /// The law of the ray of pixel (i, j) over a way of `way_m`:
    /// L = b p(angle) E_n exp(-c d0 / mu_s) (1 - exp(-kappa S)) / kappa, kappa = c (1 + mu / mu_s).
    double law(int i, int j, double way_m) const {
        const Camera& c = image.camera;
        const glm::dvec3 r = glm::normalize(c.rays().at(i, j)), sun = Sun{elevation_deg, azimuth_deg, 1}.direction();
        const f64::Refraction f = f64::refract_sun(sun, {0, 0}, 4.0 / 3, 1);
        const glm::dvec3 light = glm::dvec3{f.travel.x, f.travel.y, -1} / f.path;
        const double across = f.incident * f.transmittance * f.path;
        const double kappa = .15 * (1 - r.z * f.path);
        return .05 * f64::henyey_greenstein(.9, -glm::dot(light, r)) * across *
               std::exp(.15 * c.position_m.z * f.path) * (1 - std::exp(-kappa * way_m)) / kappa;
    }

    Field<float> draw() const {
        BeamImage out;
        draw_beams(image, beams, out);
        return std::move(out.radiance);
    }
};

TEST(BeamImage, FlatWaterIsTheClosedForm) {
    FlatPool pool({64, 64}, 90, 0);
    pool.image.camera.position_m = {0, 5, -1};
    pool.image.camera.target_m = {10, 5, -1};
    pool.image.camera.size = {61, 41};
    pool.image.camera.fov_deg = 20;
    EXPECT_NEAR(pool.law(30, 20, 10), 1.355670e-3, 1e-8);
    const Field<float> picture = pool.draw();
    EXPECT_NEAR(picture(30, 20) / 1.355670e-3, 1, 5e-3);
}

/// RMS of the picture over the law less one, in per cent, where all of the ray's way is known: level rays to the far
/// wall, and rays to the floor.
double residual_percent(const FlatPool& pool, const Field<float>& picture) {
    const Camera& c = pool.image.camera;
    double squares = 0;
    int count = 0;
    for (int j = 0; j < c.size.y; ++j) {
        for (int i = 0; i < c.size.x; ++i) {
            const glm::dvec3 r = glm::normalize(c.rays().at(i, j));
            const double wall_x = ((r.x > 0 ? 10 : 0) - c.position_m.x) / r.x;
            const double wall_y = ((r.y > 0 ? 10 : 0) - c.position_m.y) / r.y;
            const double level = ((r.z < 0 ? -4 : 0) - c.position_m.z) / r.z;
            const double way = std::min({wall_x, wall_y, level});
            const double off = picture(i, j) / pool.law(i, j, way) - 1;
            squares += off * off;
            ++count;
        }
    }
    return 100 * std::sqrt(squares / count);
}

TEST(BeamImage, TheGridLeavesNoPatternOnAndOffAxis) {
    for (const int n : {16, 37, 64}) {
        for (const bool off_axis : {false, true}) {
            FlatPool pool({n, n}, 90, 0);
            pool.image.camera.position_m = off_axis ? glm::dvec3{.4, 1.3, -.7} : glm::dvec3{0, 5, -2};
            pool.image.camera.target_m = off_axis ? glm::dvec3{9, 8, -2.6} : glm::dvec3{10, 5, -2};
            const double residual = residual_percent(pool, pool.draw());
            RecordProperty("residual_percent_" + std::to_string(n) + (off_axis ? "_off" : "_on"),
                           std::to_string(residual));
            EXPECT_LT(residual, n == 16 ? 0.5 : 0.1);
        }
    }
}

TEST(BeamImage, SlantingSunOverStillWaterThatGoesOn) {
    // An absorbing side: light enters beyond the domain, so that slanting beams fill it.
    FlatPool pool({48, 48}, 50, 30, {Side::absorbing, Side::absorbing});
    pool.image.camera.position_m = {2, 2, -3};
    pool.image.camera.target_m = {4, 4, -2.5};
    pool.image.camera.fov_deg = 30;
    const Field<float> picture = pool.draw();
    // Rays up to the surface, whose way is known.
    for (const int i : {10, 45, 80}) {
        const int j = 59;
        const glm::dvec3 r = glm::normalize(pool.image.camera.rays().at(i, j));
        ASSERT_GT(r.z, 0);
        EXPECT_NEAR(picture(i, j) / pool.law(i, j, 3 / r.z), 1, 5e-3) << i;
    }
}

TEST(BeamImage, PeriodicSidesRepeatTheBeams) {
    FlatPool small({16, 16}, 60, 20, {Side::periodic, Side::periodic});
    small.image.camera.position_m = {5, 5, -3};
    small.image.camera.target_m = {9, 6, -3.4};
    small.image.range_m = 60;
    const Field<float> picture = small.draw();
    for (const int i : {0, 45, 89}) {
        const glm::dvec3 r = glm::normalize(small.image.camera.rays().at(i, 10));
        ASSERT_LT(r.z, 0);
        EXPECT_NEAR(picture(i, 10) / small.law(i, 10, -1 / r.z), 1, 5e-3) << i;
    }
}

TEST(BeamImage, LookingAlongTheLight) {
    // Straight up into an overhead sun the rays run along the beams.
    FlatPool pool({64, 64}, 90, 0);
    pool.image.camera.position_m = {5.03, 5.02, -3};
    pool.image.camera.target_m = {5.03, 5.02, 0};
    const Field<float> picture = pool.draw();
    double worst = 0;
    for (int j = 0; j < 60; ++j)
        for (int i = 0; i < 90; ++i) {
            const glm::dvec3 r = glm::normalize(pool.image.camera.rays().at(i, j));
            worst = std::max(worst, std::abs(picture(i, j) / pool.law(i, j, 3 / r.z) - 1));
        }
    EXPECT_LT(worst, 5e-3);
}

/// Light from a sine's waves, past their focus, from the side: waves along the view, so that few beams hide many.
struct Shafts {
    Beams beams;
    BeamImageSettings image;
    explicit Shafts(int beam_columns, int samples = 1);
    Field<float> draw() const {
        BeamImage out;
        draw_beams(image, beams, out);
        return std::move(out.radiance);
    }
};

Shafts::Shafts(int beam_columns, int samples) {
    const Grid grid = make_grid(512, 16, 2, 1);
    const Surface surface = sample(grid, walls, sines({{.01, .5, 0}}));
    BeamSettings s;
    s.grid = {beam_columns, 32};
    s.depth_m = 4;
    s.sun = {80, 0, 1};
    s.optics.scattering_per_m = .05;
    make_beams(s, surface, beams);
    image.optics = s.optics;
    image.samples = samples;
    image.camera = {{1, -2.5, -2}, {1, 1, -2}, 60, {180, 120}};
}

/// What a ray of that scene gathers, by sums over places on its way.
double by_places(const Beams& beams, const BeamImageSettings& s, int i, int j, int places) {
    const glm::dvec3 eye = s.camera.position_m, r = s.camera.rays().at(i, j);
    const double length = glm::length(r), near = (0 - eye.y) / r.y, far = (1 - eye.y) / r.y;
    const glm::dvec3 light = glm::normalize(glm::dvec3{beams.travel_x(0, 0), beams.travel_y(0, 0), -1});
    double sum = 0;
    for (int k = 0; k < places; ++k) {
        const double t = near + (far - near) * (k + .5) / places;
        const double scattered = s.optics.scattering_per_m *
                                 f64::henyey_greenstein(s.optics.phase.g, -glm::dot(light, r) / length) *
                                 irradiance_at(beams, eye + t * r).scalar_w_m2;
        sum += scattered * std::exp(-beams.extinction_per_m * (t - near) * length) * (far - near) * length / places;
    }
    return sum;
}

double rmse(const Field<float>& a, const Field<float>& b) {
    double difference = 0, square = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        difference += (a.data()[i] - b.data()[i]) * (a.data()[i] - b.data()[i]);
        square += b.data()[i] * b.data()[i];
    }
    return std::sqrt(difference / square);
}

TEST(BeamImage, FinerGridsConverge) {
    const Field<float> fine = Shafts(1024).draw();
    double last = 1;
    for (const int n : {64, 128, 256}) {
        const double error = rmse(Shafts(n).draw(), fine);
        RecordProperty("rmse_percent_" + std::to_string(n), std::to_string(100 * error));
        EXPECT_LT(error, 0.4 * last) << "second order, past the focus too";
        last = error;
    }
    EXPECT_LT(last, 0.001);
}

TEST(BeamImage, APictureIsTheSumOverPlacesInTheWater) {
    // One beam's area polynomial after another, against the sum over whole rays.
    const Shafts shafts(128);
    const Field<float> picture = shafts.draw();
    double difference = 0, square = 0;
    for (const int i : {20, 45, 88, 103, 160})
        for (const int j : {20, 60, 75}) {
            const double expected = by_places(shafts.beams, shafts.image, i, j, 300);
            difference += (picture(i, j) - expected) * (picture(i, j) - expected);
            square += expected * expected;
        }
    EXPECT_LT(std::sqrt(difference / square), 0.01);
}

/// A few crests on otherwise flat water, whose light alone converges.
SurfacePoint crests(glm::dvec2 at) {
    SurfacePoint sum;
    for (const glm::dvec2 centre : {glm::dvec2{.6, .7}, {1.4, 1.3}}) {
        const double r2 = glm::dot(at - centre, at - centre), width2 = .006;
        const double bump = .004 * std::exp(-r2 / (2 * width2));
        sum.elevation_m += bump;
        sum.slope -= bump / width2 * (at - centre);
    }
    return sum;
}

TEST(BeamImage, RefiningWhereLightConvergesCostsLessThanTheFinerGrid) {
    const Surface surface = sample(make_grid(256, 256, 2, 2), walls, crests);
    BeamSettings s;
    s.grid = {32, 32};
    s.depth_m = 3;
    s.sun = {75, 0, 1};
    s.optics.scattering_per_m = .05;
    BeamImageSettings picture;
    picture.optics = s.optics;
    picture.camera = {{1, -3, -1.5}, {1, 1, -1.5}, 50, {180, 120}};
    RefinedBeams refined;
    make_refined_beams(s, .9, surface, refined);
    EXPECT_GT(refined.refined_cells, 0);
    EXPECT_LT(refined.refined_cells, 512);
    BeamImage of_refined, of_coarse, of_fine;
    draw_beams(picture, refined, of_refined);
    Beams beams;
    make_beams(s, surface, beams);
    draw_beams(picture, beams, of_coarse);
    s.grid = {64, 64};
    make_beams(s, surface, beams);
    draw_beams(picture, beams, of_fine);
    const double error = rmse(of_refined.radiance, of_fine.radiance);
    RecordProperty("rmse_percent_refined", std::to_string(100 * error));
    RecordProperty("rmse_percent_coarse", std::to_string(100 * rmse(of_coarse.radiance, of_fine.radiance)));
    RecordProperty("sections_of_fine", std::to_string(double(of_refined.counts.sections) / of_fine.counts.sections));
    EXPECT_LT(error, 0.5 * rmse(of_coarse.radiance, of_fine.radiance));
    EXPECT_LT(of_refined.counts.sections, 0.8 * of_fine.counts.sections);
    double flux = 0, all = 0;
    for (const Beams* b : {&refined.coarse, &refined.fine})
        for (const float f : b->flux.values()) flux += f;
    for (const float f : beams.flux.values()) all += f;
    EXPECT_NEAR(flux / all, 1, 1e-4) << "each cell's light is in one of both grids";
}

TEST(BeamImage, FewerRaysEnlargedStayClose) {
    // Edges of the pool included; odd sizes do not divide.
    for (const glm::ivec2 size : {glm::ivec2{360, 240}, {361, 239}}) {
        Shafts shafts(128);
        shafts.image.camera.size = size;
        const Field<float> full = shafts.draw();
        for (const int reduction : {2, 3, 4}) {
            shafts.image.reduction = reduction;
            const double error = rmse(shafts.draw(), full);
            RecordProperty("rmse_percent_" + std::to_string(size.x) + "_" + std::to_string(reduction),
                           std::to_string(100 * error));
            EXPECT_LT(error, 0.02 * reduction);
        }
    }
}

TEST(BeamImage, FlatWaterSurvivesEnlarging) {
    // What is left is where the ways through the water crease, a line of pixels wide.
    FlatPool pool({64, 64}, 90, 0);
    pool.image.camera.position_m = {.4, 1.3, -.7};
    pool.image.camera.target_m = {9, 8, -2.6};
    pool.image.reduction = 2;
    double last = 2;
    for (const int k : {1, 2, 4}) {
        pool.image.camera.size = {90 * k, 60 * k};
        const double residual = residual_percent(pool, pool.draw());
        RecordProperty("residual_percent_" + std::to_string(90 * k), std::to_string(residual));
        EXPECT_LT(residual, 0.75 * last);
        last = residual;
    }
    EXPECT_LT(last, 0.5);
}

TEST(BeamImage, AlongTheLightUnderWavesNoRayIsLost) {
    // Towards the sun rays run along the beams, where sections are ill defined.
    const Grid grid = make_grid(128, 128, 4, 4);
    const Surface surface = sample(grid, {Side::periodic, Side::periodic}, egg_crate(.004, 1));
    BeamSettings s;
    s.grid = {64, 64};
    s.depth_m = 4;
    s.sun = {70, 30, 1};
    s.optics.scattering_per_m = .1;
    s.optics.phase.g = .5;
    Beams beams;
    make_beams(s, surface, beams);
    BeamImageSettings image;
    image.optics = s.optics;
    image.range_m = 12;
    const f64::Refraction rest = f64::refract_sun(s.sun.direction(), {0, 0}, 4.0 / 3, 1);
    const glm::dvec3 eye{1.9, 2.2, -3};
    image.camera = {eye, eye + glm::dvec3{-rest.travel, 1}, 20, {120, 80}};
    BeamImage one, many;
    draw_beams(image, beams, one);
    image.samples = 32;
    draw_beams(image, beams, many);
    const auto [least, most] = std::minmax_element(many.radiance.values().begin(), many.radiance.values().end());
    EXPECT_GT(*std::min_element(one.radiance.values().begin(), one.radiance.values().end()), 0.5F * *least);
    EXPECT_LT(*std::max_element(one.radiance.values().begin(), one.radiance.values().end()), 2.0F * *most);
    Field<float> reference = many.radiance.clone();
    const double error = rmse(one.radiance, reference);
    RecordProperty("rmse_percent_one_section", std::to_string(100 * error));
    EXPECT_LT(error, 0.01);
}

TEST(BeamImage, MoreSectionsOfARayConverge) {
    // Coarse cells, in whose long chords one sample in the middle is not enough.
    const Field<float> fine = Shafts(24, 32).draw();
    double last = 1;
    for (const int samples : {1, 2, 4, 8}) {
        const double error = rmse(Shafts(24, samples).draw(), fine);
        RecordProperty("rmse_percent_samples_" + std::to_string(samples), std::to_string(100 * error));
        EXPECT_LT(error, 0.7 * last) << samples;
        last = error;
    }
}

}  // namespace
}  // namespace waterlight
