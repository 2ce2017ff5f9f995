// Photons through glass, against rays traced on paper: in the plane of a sphere's axis all is exact.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/photon_stage.hpp"

namespace waterlight {
namespace {

using namespace test;
using Branching = PhotonOptions::Branching;
using Start = PhotonOptions::Start;
using std::numbers::pi;

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

TEST(PhotonGlass, AGlassSphereLightsAPlaneAsOnPaper) {
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

TEST(PhotonGlass, AGlassSphereFocusesWhereThePaperSays) {
    for (const double beyond : {2.25, 2.5}) {
        Stage stage(2.4, 120, 1.5 + beyond, glass_ball(1, {0, 0, -1.5}));
        stage.settings.options.map = 1024;
        EXPECT_NEAR(focal_length(stage, stage.map(), beyond, 0.96 * 0.96, 0.04), 1.5 / (2 * (1.5 - 1)), 0.01);
    }
}

TEST(PhotonGlass, InWaterAGlassSphereIsAWeakerLens) {
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

TEST(PhotonGlass, BlueLightIsFocusedNearerThanRed) {
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

TEST(PhotonGlass, AGlassSphereKeepsWhatItAbsorbs) {
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

}  // namespace
}  // namespace waterlight
