// Photons among objects, against rays traced on paper: in the plane of a sphere's axis all is exact.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "caustics/kernels/optics.hpp"
#include "tests/support/photon_maps.hpp"

namespace waterlight {
namespace {

using namespace test;
using Branching = PhotonOptions::Branching;
using Start = PhotonOptions::Start;
constexpr double pi = std::numbers::pi;
constexpr Boundary open_sides{Side::absorbing, Side::absorbing};

/// Where parallel light of 1 W/m2 from straight above lands on the plane `below` the centre of a sphere of radius 1 and
/// relative index n: power on the pixels of a square about the axis. A ray at the distance h from the axis meets the
/// sphere at the angle i, sin i = h, and is refracted to r, sin r = h / n; each chord carries it by pi - 2 r about the
/// centre, each reflection within turns it by as much, and each refraction by i - r. Left out: what leaves upwards, and
/// more than fourteen reflections.
class SphereOnPaper {
  public:
    SphereOnPaper(double n, double below, int pixels, double pitch)
        : below_(below), pitch_(pitch), power_(pixels, pixels) {
        const int rays = 1 << 20;
        for (int q = 0; q < rays; ++q) {
            const double h = (q + 0.5) / rays, i = std::asin(h), r = std::asin(h / n), chord = pi - 2 * r;
            const double light = 2 * pi * h / rays, through = transmittance(i, r);
            // About the axis by the golden angle, so that each ring is lit all round.
            azimuth_ = std::fmod(q * 2.399963229728653, 2 * pi);
            land(i, 2 * i, light * (1 - through));
            double within = light * through;
            for (int k = 0; k <= 14 && within > 1e-9 * light; ++k) {
                land(i + (k + 1) * chord, pi + 2 * (i - r) + k * chord, within * through);
                within *= 1 - through;
            }
        }
        // Beside the sphere light goes straight on.
        for (int j = 0; j < pixels; ++j)
            for (int i = 0; i < pixels; ++i) power_(i, j) += beside(i, j) * pitch * pitch;
    }

    double irradiance(int i, int j) const { return power_(i, j) / (pitch_ * pitch_); }

  private:
    /// Fresnel's formulas by their angles.
    static double transmittance(double i, double r) {
        const double s = std::sin(i - r) / std::sin(i + r), p = std::tan(i - r) / std::tan(i + r);
        return 1 - (s * s + p * p) / 2;
    }
    /// From the place and along the direction at these angles from the zenith.
    void land(double at, double along, double power) {
        if (std::cos(along) >= 0) return;
        const double distance = std::sin(at) - (std::cos(at) + below_) * std::tan(along);
        const double half = 0.5 * power_.nx();
        const double i = half + distance * std::cos(azimuth_) / pitch_,
                     j = half + distance * std::sin(azimuth_) / pitch_;
        if (i >= 0 && i < 2 * half && j >= 0 && j < 2 * half) power_(static_cast<int>(i), static_cast<int>(j)) += power;
    }
    /// The part of a pixel that the sphere does not shade.
    double beside(int i, int j) const {
        const int parts = 16;
        const glm::dvec2 corner = pitch_ * (glm::dvec2(i, j) - 0.5 * power_.nx());
        int lit = 0;
        for (int b = 0; b < parts; ++b)
            for (int a = 0; a < parts; ++a)
                lit += glm::length(corner + pitch_ / parts * glm::dvec2(a + 0.5, b + 0.5)) > 1 ? 1 : 0;
        return static_cast<double>(lit) / (parts * parts);
    }

    double below_, pitch_, azimuth_ = 0;
    Field<double> power_;
};

Object glass_ball(double radius, glm::dvec3 centre) {
    return {.name = "ball",
            .shape = Sphere{radius},
            .material = {.type = Material::Type::glass, .index = 1.5},
            .centre_m = centre};
}

/// A square of this size about the origin under the sun overhead, with one object; the water is not to be seen.
struct Stage {
    Grid grid;
    Surface surface;
    PhotonSettings settings;
    Stage(double size_m, int pixels, double depth_m, Object object)
        : grid{4, 4, size_m / 4, size_m / 4, -size_m / 2, -size_m / 2},
          surface(grid, open_sides),
          settings(photons_over(grid, pixels, pixels, 90)) {
        settings.floor.depth_m = depth_m;
        settings.floor.sun.irradiance_w_m2 = 1;
        settings.floor.optics.refractive_index = 1;
        settings.floor.objects = objects({std::move(object)});
    }
    double pitch_m() const { return settings.floor.plan.pitch_m.x; }
    glm::dvec2 place(int i, int j) const { return settings.floor.plan.position_m({i + 0.5, j + 0.5}); }
    FloorMap map() const { return photon_map(settings, surface).map; }
    /// Mean of the map within this distance of the axis.
    double around_axis(const FloorMap& map, double distance) const {
        double sum = 0;
        int pixels = 0;
        for (int j = 0; j < map.irradiance.ny(); ++j)
            for (int i = 0; i < map.irradiance.nx(); ++i)
                if (glm::length(place(i, j)) < distance) {
                    sum += map.irradiance(i, j);
                    ++pixels;
                }
        return sum / pixels;
    }
};

TEST(PhotonObjects, AGlassSphereLightsAPlaneAsOnPaper) {
    // Planes before, in and beyond the paraxial focus at 1.5 R, which rays far from the axis cross before it.
    for (const double below : {1.05, 1.3, 2.0, 3.0}) {
        Stage stage(4.4, 220, 1.5 + below, glass_ball(1, {0, 0, -1.5}));
        stage.settings.options.map = below < 1.2 ? 2048 : 1024;
        stage.settings.options.branching = Branching::split;
        const FloorMap map = stage.map();
        const SphereOnPaper paper(1.5, below, 220, stage.pitch_m());
        constexpr int rings = 22;
        std::vector<double> found(rings, 0.0), expected(rings, 0.0);
        for (int j = 0; j < 220; ++j)
            for (int i = 0; i < 220; ++i) {
                const auto ring = static_cast<std::size_t>(glm::length(stage.place(i, j)) / 0.1);
                if (ring >= rings) continue;
                found[ring] += map.irradiance(i, j);
                expected[ring] += paper.irradiance(i, j);
            }
        for (std::size_t ring = 0; ring < rings; ++ring)
            EXPECT_NEAR(found[ring], expected[ring], 0.02 * expected[ring]) << below << " ring " << ring;
        EXPECT_LT(map.ledger.closure(), 1e-12);
        EXPECT_LT(map.ledger.lost_w, 1e-4 * map.ledger.incident_w);
    }
}

/// By the irradiance on the axis at the distance L beyond the focus, E0 T^2 / (L / f - 1)^2: there no other light
/// crosses it, from about 3 R on that which was reflected twice within does.
double focal_length(const Stage& stage, const FloorMap& map, double distance, double transmitted, double disc) {
    return distance / (1 + std::sqrt(transmitted / stage.around_axis(map, disc)));
}

TEST(PhotonObjects, AGlassSphereFocusesWhereThePaperSays) {
    for (const double beyond : {2.25, 2.5}) {
        Stage stage(2.4, 120, 1.5 + beyond, glass_ball(1, {0, 0, -1.5}));
        stage.settings.options.map = 1024;
        EXPECT_NEAR(focal_length(stage, stage.map(), beyond, 0.96 * 0.96, 0.04), 1.5 / (2 * (1.5 - 1)), 0.01);
    }
}

TEST(PhotonObjects, InWaterAGlassSphereIsAWeakerLens) {
    const double n = 1.5 / (4.0 / 3), radius = 0.2, focus = n * radius / (2 * (n - 1)), beyond = 1.8;
    Stage stage(0.5, 100, 0.3 + beyond, glass_ball(radius, {0, 0, -0.3}));
    stage.settings.floor.optics.refractive_index = 4.0 / 3;
    stage.settings.options.map = 1024;
    const double into_water = 1 - std::pow(1.0 / 7, 2), into_glass = 1 - std::pow((n - 1) / (n + 1), 2);
    for (const Start start : {Start::light, Start::surface}) {
        stage.settings.options.start = start;
        EXPECT_NEAR(focal_length(stage, stage.map(), beyond, into_water * into_glass * into_glass, 0.012), focus,
                    0.01 * focus);
    }
}

TEST(PhotonObjects, BlueLightIsFocusedNearerThanRed) {
    Object ball = glass_ball(1, {0, 0, -1.5});
    ball.material.abbe_number = 30;
    double last = 0;
    for (const double wavelength : {486.1, 587.6, 656.3}) {
        Stage stage(2.4, 120, 4, ball);
        stage.settings.floor.wavelength_nm = wavelength;
        stage.settings.options.map = 1024;
        const double n = ball.material.index_at(wavelength), into = 1 - std::pow((n - 1) / (n + 1), 2);
        const double focus = focal_length(stage, stage.map(), 2.5, into * into, 0.06);
        EXPECT_NEAR(focus, n / (2 * (n - 1)), 0.01) << wavelength;
        EXPECT_GT(focus, last + 0.005);
        last = focus;
    }
}

TEST(PhotonObjects, AGlassSphereKeepsWhatItAbsorbs) {
    Object ball = glass_ball(1, {0, 0, -1.5});
    Stage clear(2.4, 24, 4, ball);
    clear.settings.options.map = 256;
    EXPECT_EQ(clear.map().ledger.objects_w, 0);
    ball.material.absorption_per_m = 0.5;
    Stage dark(2.4, 24, 4, ball);
    dark.settings.options.map = 256;
    // Of each first chord, 2 cos r long, and of the few that follow it.
    double taken = 0;
    for (int q = 0; q < 10000; ++q) {
        const double h = (q + 0.5) / 10000, i = std::asin(h), r = std::asin(h / 1.5);
        const double s = std::sin(i - r) / std::sin(i + r), p = std::tan(i - r) / std::tan(i + r);
        const double back = (s * s + p * p) / 2, left = std::exp(-0.5 * 2 * std::cos(r));
        taken += 2 * pi * h / 10000 * (1 - back) * (1 - left) / (1 - back * left);
    }
    const FloorLedger ledger = dark.map().ledger;
    EXPECT_NEAR(ledger.objects_w, taken, 2e-3 * taken);
    EXPECT_LT(ledger.closure(), 1e-12);
}

TEST(PhotonObjects, AMirrorRingsCaustic) {
    // Parallel light in a circle is reflected into a nephroid, its cusp at half the radius before the mirror (a
    // cardioid it is for a lamp on the circle). On the plane that the ring stands on light from the height z lands z /
    // tan(el) before the mirror: at 45 degrees a ring half as high as it is wide lights all of it.
    const double radius = 0.5;
    Stage stage(1.1, 220, 1,
                {.name = "ring",
                 .shape = Ring{radius, 0.52, 0.5},
                 .material = {.type = Material::Type::mirror, .reflectance = 0.9},
                 .centre_m = {0, 0, -0.75}});
    stage.settings.floor.sun = {45, 0, 1};
    stage.settings.options.map = 2048;
    const FloorMap map = stage.map();
    const auto on_axis = [&](int i) { return (map.irradiance(i, 109) + map.irradiance(i, 110)) / 2; };
    // Before the cusp one reflected ray is on the axis, E0 sin(el) .9 / (t / f - 1) at the distance t from the mirror,
    // over the sun's own light.
    double cusp = 0;
    int places = 0;
    for (int i = 70; i < 100; ++i, ++places) {
        const double t = stage.place(i, 110).x + radius, sun = std::sin(pi / 4);
        cusp += t / (1 + 0.9 * sun / (on_axis(i) - sun));
    }
    EXPECT_NEAR(cusp / places, radius / 2, 0.01 * radius / 2);
    // Beyond it there are three, so that the brightest pixel lies a little on that side.
    int brightest = 15;
    for (int i = 15; i < 205; ++i)
        if (on_axis(i) > on_axis(brightest)) brightest = i;
    EXPECT_NEAR(stage.place(brightest, 110).x, -radius / 2 - 1.5 * stage.pitch_m(), 2 * stage.pitch_m());
    EXPECT_LT(map.ledger.closure(), 1e-12);
    EXPECT_GT(map.ledger.objects_w, 0);
}

TEST(PhotonObjects, ADiffuseBallsShadow) {
    const double radius = 0.3;
    for (const double elevation : {90.0, 50.0})
        for (const double height : {-0.6, 0.0, 0.7}) {
            Stage stage(4, 200, 1, {.name = "ball", .shape = Sphere{radius}, .centre_m = {0.3, 0, height}});
            stage.settings.floor.sun = {elevation, 25, 1};
            stage.settings.options.map = 1024;
            const FloorMap map = stage.map();
            const double across = std::sin(elevation * pi / 180);
            double dark = 0;
            for (const float e : map.irradiance.values()) dark += (1 - e / across) * std::pow(stage.pitch_m(), 2);
            const double area = pi * radius * radius / across;
            EXPECT_NEAR(dark, area, 0.01 * area) << elevation << ' ' << height;
            EXPECT_NEAR(map.ledger.objects_w, area * across, 0.01 * area);
            EXPECT_LT(map.ledger.closure(), 1e-12);
        }
}

TEST(PhotonObjects, WhatStandsPartlyBeyondASideStopsAllThatFallsOnIt) {
    Stage stage(4, 40, 1, {.name = "ball", .shape = Sphere{0.3}, .centre_m = {-2, 0, 0.7}});
    stage.settings.options.map = 512;
    for (const Side side : {Side::wall, Side::absorbing}) {
        stage.surface.boundary = {side, side};
        const FloorLedger ledger = stage.map().ledger;
        const double area = pi * 0.09;
        EXPECT_NEAR(ledger.objects_w, area, 0.01 * area);
        EXPECT_NEAR(ledger.incident_w, 16 + area / 2, 0.01 * area)
            << "the half beyond the side comes in by the ball alone";
        EXPECT_LT(ledger.closure(), 1e-12);
    }
}

TEST(PhotonObjects, InWaterTheShadowIsThatOfTheRefractedLight) {
    const double radius = 0.3, sine = std::cos(50 * pi / 180) / (4.0 / 3);
    for (const Start start : {Start::light, Start::surface}) {
        Stage stage(4, 200, 1, {.name = "ball", .shape = Sphere{radius}, .centre_m = {0.3, 0, -0.6}});
        stage.settings.floor.optics.refractive_index = 4.0 / 3;
        stage.settings.floor.sun = {50, 25, 1};
        stage.settings.options = {.start = start, .map = 1024};
        const FloorMap map = stage.map();
        const f64::Refraction r = f64::refract_sun(stage.settings.floor.sun.direction(), {0, 0}, 4.0 / 3, 1);
        const double clear = r.incident * r.transmittance;
        double dark = 0;
        for (const float e : map.irradiance.values()) dark += (1 - e / clear) * std::pow(stage.pitch_m(), 2);
        const double area = pi * radius * radius / std::sqrt(1 - sine * sine);
        EXPECT_NEAR(dark, area, 0.01 * area);
    }
}

/// Glass, mirror and diffuse things in waves, some of them through the surface.
PhotonSettings crowd(const Grid& grid) {
    PhotonSettings s = photons_over(grid, 24, 24, 60);
    s.floor.optics.absorption_per_m = 0.1;
    s.floor.objects = objects(
        {glass_ball(0.15, {0.3, 0.3, 0.02}),
         {.name = "cup",
          .shape = Cup{0.15, 0.2, 0.4, 0.02, 0.03},
          .material = {.type = Material::Type::glass, .absorption_per_m = 1},
          .centre_m = {0.7, 0.6, -0.9},
          .rotation_deg = {20, 0, 0}},
         {.name = "ring",
          .shape = Ring{0.1, 0.12, 0.1},
          .material = {.type = Material::Type::mirror, .reflectance = 0.8},
          .centre_m = {0.3, 0.75, -0.5}},
         {.name = "box", .shape = Box{{0.1, 0.2, 0.1}}, .centre_m = {0.75, 0.2, -0.7}, .rotation_deg = {0, 30, 10}}});
    return s;
}

Surface rippled(const Grid& grid, Boundary boundary) {
    Surface surface(grid, boundary);
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) {
            const double k = 4 * pi, x = k * grid.x_m(i), y = k * grid.y_m(j);
            surface.elevation(i, j) = static_cast<float>(0.01 * std::cos(x) * std::cos(y));
            surface.slope_x(i, j) = static_cast<float>(-0.01 * k * std::sin(x) * std::cos(y));
            surface.slope_y(i, j) = static_cast<float>(-0.01 * k * std::cos(x) * std::sin(y));
        }
    return surface;
}

TEST(PhotonObjects, SplittingAndRouletteAgreeWithinTheirErrors) {
    const Grid grid = make_grid(64, 64, 1, 1);
    for (const Side side : {Side::periodic, Side::wall, Side::absorbing}) {
        const Surface surface = rippled(grid, {side, side});
        PhotonSettings s = crowd(grid);
        s.options.map = 192;
        s.options.passes = 8;
        const PhotonResult roulette = photon_map(s, surface);
        s.options.branching = Branching::split;
        s.options.seed = 2;
        const PhotonResult split = photon_map(s, surface);
        const double off = relative_difference(roulette.map.irradiance, split.map.irradiance);
        const double ratio = std::hypot(roulette.error, split.error) / off;
        EXPECT_GT(ratio, 0.8) << int(side);
        EXPECT_LT(ratio, 1.25) << int(side);
        for (const FloorLedger& l : {roulette.map.ledger, split.map.ledger}) {
            EXPECT_LT(l.closure(), 1e-12);
            EXPECT_LT(l.lost_w, 1e-3 * l.incident_w);
        }
        const FloorLedger &a = roulette.map.ledger, &b = split.map.ledger;
        EXPECT_NEAR(a.floor_w, b.floor_w, 5e-3 * b.floor_w);
        EXPECT_NEAR(a.objects_w, b.objects_w, 0.02 * b.objects_w);
        EXPECT_NEAR(a.reflected_w, b.reflected_w, 0.03 * b.reflected_w);
        EXPECT_NEAR(a.extinguished_w, b.extinguished_w, 5e-3 * b.extinguished_w);
    }
}

TEST(PhotonObjects, BothStartsAgreeAroundWhatLiesUnderWater) {
    const Grid grid = make_grid(64, 64, 1, 1);
    const Surface surface = rippled(grid, {});
    PhotonSettings s = photons_over(grid, 24, 24, 60);
    s.floor.objects = objects({glass_ball(0.15, {0.4, 0.4, -0.3})});
    s.options = {.start = Start::surface, .map = 192, .passes = 8};
    const PhotonResult from_surface = photon_map(s, surface);
    s.options.start = Start::light;
    s.options.seed = 2;
    const PhotonResult from_light = photon_map(s, surface);
    const double off = relative_difference(from_surface.map.irradiance, from_light.map.irradiance);
    EXPECT_NEAR(std::hypot(from_surface.error, from_light.error) / off, 1, 0.2);
    EXPECT_NEAR(from_surface.map.ledger.floor_w, from_light.map.ledger.floor_w, 2e-3 * from_light.map.ledger.floor_w);
}

TEST(PhotonObjects, GoOnAcrossPeriodicSides) {
    // The same ball in the middle, on a corner, and a period away: the same light, elsewhere.
    const Grid grid = make_grid(16, 16, 1, 1);
    const Surface surface(grid, {});
    for (const Material::Type type : {Material::Type::diffuse, Material::Type::glass}) {
        std::vector<PhotonResult> found;
        for (const glm::dvec2 at : {glm::dvec2{0.5, 0.5}, {0, 0}, {-1.5, 0.5}})
            for (const double z : {-0.6, 0.5}) {
                PhotonSettings s = photons_over(grid, 32, 32, 40);
                s.options.map = 256;
                Object ball = glass_ball(0.2, {at, z});
                ball.material.type = type;
                s.floor.objects = objects({ball});
                found.push_back(photon_map(s, surface));
            }
        for (std::size_t k = 2; k < found.size(); ++k) {
            const FloorMap &middle = found[k % 2].map, &moved = found[k].map;
            EXPECT_LT(moved.ledger.closure(), 1e-12);
            EXPECT_NEAR(moved.ledger.objects_w, middle.ledger.objects_w, 0.01 * middle.ledger.objects_w);
            EXPECT_NEAR(moved.ledger.floor_w, middle.ledger.floor_w, 0.005 * middle.ledger.floor_w);
            const int by = k < 4 ? 16 : 0;
            double difference = 0, square = 0;
            for (int j = 0; j < 32; ++j)
                for (int i = 0; i < 32; ++i) {
                    const double a = middle.irradiance(i, j), b = moved.irradiance((i + by) % 32, (j + by) % 32);
                    difference += (a - b) * (a - b);
                    square += a * a;
                }
            EXPECT_LT(std::sqrt(difference / square), 0.08) << int(type) << ' ' << k << " noise";
        }
    }
}

TEST(PhotonObjects, WhatMeetsTooManyInterfacesIsLostAndCounted) {
    const Grid grid = make_grid(64, 64, 1, 1);
    const Surface surface = rippled(grid, {});
    PhotonSettings s = crowd(grid);
    s.options.map = 64;
    double last = 1e300;
    for (const int bounces : {1, 2, 4, 8}) {
        s.options.bounces = bounces;
        const FloorLedger ledger = photon_map(s, surface).map.ledger;
        EXPECT_LT(ledger.closure(), 1e-12);
        EXPECT_LT(ledger.lost_w, 0.7 * last) << bounces;
        last = ledger.lost_w;
    }
}

}  // namespace
}  // namespace waterlight
