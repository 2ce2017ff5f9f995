// The landing by iteration in the light's image, against the exact meeting.
//
// Light that falls with m_s horizontal metres a metre of descent, a ray below water with m_r, ground with the gradient
// g, c = 1 / sqrt(1 + m_r^2). At distance d the ray is e = e0 - c (1 + g.m_r) d above the ground; the light goes down
// from there by e / (1 + g.m_s) until it meets it. The paper's next d is the distance of that place, so that near the
// solution errors are multiplied by 1 - c^2 (1 + g.m_r) (1 + m_r.m_s) / (1 + g.m_s); by height it is 1 - (1 + g.m_r) /
// (1 + g.m_s).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "caustics/first_crossing.hpp"
#include "caustics/splat/receivers.hpp"
#include "tests/support/splat_maps.hpp"

namespace waterlight {
namespace {

using namespace test;
using Landing = SplatOptions::Landing;
using Height = std::function<double(glm::dvec2)>;

const Grid sea = make_grid(400, 400, 8, 8);

struct Ground {
    const char* name;
    Height height_m;
};
const Ground flat_ground{"flat", [](glm::dvec2) { return -1.0; }};
const Ground sloped{"sloped", [](glm::dvec2 at) { return -1.0 + 0.25 * (at.x - 4); }};
const Ground bumpy{"bumpy", [](glm::dvec2 at) {
                       return -1.0 + 0.06 * std::sin(2 * std::numbers::pi * at.x / 2) *
                                         std::cos(2 * std::numbers::pi * at.y / 1.6);
                   }};

/// Landing on a ground under the sun at this elevation, azimuth 0.
class Scene {
  public:
    Scene(const Ground& ground, double elevation_deg) : ground_(ground) {
        settings_ = splat_settings(sea, 400, 400, elevation_deg);
        settings_.floor.sun.azimuth_deg = 0;
        Field<float> bed(sea.nx, sea.ny);
        for (int j = 0; j < sea.ny; ++j)
            for (int i = 0; i < sea.nx; ++i) bed(i, j) = static_cast<float>(ground.height_m({sea.x_m(i), sea.y_m(j)}));
        settings_.bed_m = std::make_shared<Field<float>>(std::move(bed));
        const Surface surface(sea, {Side::wall, Side::wall});
        frame_ = splat_frame(settings_, surface);
        receivers_.emplace(frame_, surface, *settings_.bed_m);
    }

    double landed(int iterations, Landing landing, glm::dvec3 start, glm::dvec3 direction) const {
        SplatOptions o;
        o.iterations = iterations;
        o.landing = landing;
        return land(o, frame_.light.image, *receivers_, start, direction).distance_m;
    }
    double exact(glm::dvec3 start, glm::dvec3 direction) const {
        return first_crossing({0, 4, 4000}, [&](double d) {
            const glm::dvec3 at = start + d * direction;
            return at.z - ground_.height_m(glm::dvec2(at));
        });
    }
    glm::dvec2 light_travel() const {
        const glm::dvec3 s = settings_.floor.sun.direction();
        return glm::dvec2(s) / -s.z;
    }
    /// A ray of light below water of this slope.
    glm::dvec3 ray(glm::dvec2 slope) const {
        const glm::dvec2 m = f64::refract_sun(settings_.floor.sun.direction(), slope, 4.0 / 3, 1).travel;
        return glm::normalize(glm::dvec3{m, -1});
    }
    /// Root mean square error over many rays.
    double error(int iterations, Landing landing) const {
        double sum = 0;
        int count = 0;
        for (double x = 3; x < 5; x += 0.13)
            for (double y = 3; y < 5; y += 0.17) {
                const glm::dvec2 slope{0.15 * std::sin(5 * x + y), 0.15 * std::cos(4 * y - x)};
                const glm::dvec3 start{x, y, 0.01 * std::sin(7 * x)}, direction = ray(slope);
                const double e = landed(iterations, landing, start, direction) - exact(start, direction);
                sum += e * e;
                ++count;
            }
        return std::sqrt(sum / count);
    }

  private:
    const Ground& ground_;
    SplatSettings settings_;
    SplatFrame frame_;
    std::optional<Receivers> receivers_;
};

constexpr double bilinear = 2e-4;  // m: what heights between texels are wrong by on the bumps

TEST(SplatLanding, ErrorsFallWithTheIterations) {
    for (const double elevation : {90.0, 50.0})
        for (const Landing landing : {Landing::distance, Landing::height})
            for (const Ground* ground : {&flat_ground, &sloped, &bumpy}) {
                const Scene scene(*ground, elevation);
                std::printf("sun at %g, by %s, %s ground: RMS error after 1, 2, 4, 8 steps, m:", elevation,
                            landing == Landing::height ? "height" : "distance", ground->name);
                double last = 1;
                for (const int iterations : {1, 2, 4, 8}) {
                    const double error = scene.error(iterations, landing);
                    std::printf(" %.2g", error);
                    const double floor = ground == &bumpy ? bilinear : 1e-6;
                    EXPECT_LT(error, std::max(0.5 * last, floor)) << iterations;
                    last = error;
                }
                std::printf("\n");
            }
}

TEST(SplatLanding, ByHeightLevelGroundIsMetAtOnceUnderAnySun) {
    for (const double elevation : {90.0, 30.0, 5.0}) {
        const Scene scene(flat_ground, elevation);
        EXPECT_LT(scene.error(1, Landing::height), 1e-9) << elevation;
    }
}

TEST(SplatLanding, TheFactorOfEachStepIsThatOfTheory) {
    const auto measured = [](const Scene& scene, Landing landing, glm::dvec3 start, glm::dvec3 ray, int from) {
        const double exact = scene.exact(start, ray);
        return (scene.landed(from + 1, landing, start, ray) - exact) /
               (scene.landed(from, landing, start, ray) - exact);
    };
    for (const Ground* ground : {&flat_ground, &sloped})
        for (const double elevation : {60.0, 35.0, 25.0}) {
            const Scene scene(*ground, elevation);
            const glm::dvec2 slope{0.05, 0.1}, g{ground == &sloped ? 0.25 : 0, 0};
            const glm::dvec3 ray = scene.ray(slope), start{4.3, 3.9, 0.02};
            const glm::dvec2 m_r = glm::dvec2(ray) / -ray.z, m_s = scene.light_travel();
            const double c2 = ray.z * ray.z;
            const double by_distance =
                1 - c2 * (1 + glm::dot(g, m_r)) * (1 + glm::dot(m_r, m_s)) / (1 + glm::dot(g, m_s));
            const double by_height = 1 - (1 + glm::dot(g, m_r)) / (1 + glm::dot(g, m_s));
            std::printf("%s ground, sun at %g: factor by distance %.4f, by height %.4f\n", ground->name, elevation,
                        by_distance, by_height);
            EXPECT_NEAR(measured(scene, Landing::distance, start, ray, 3), by_distance, 0.05 * std::abs(by_distance));
            if (ground != &sloped) continue;
            EXPECT_NEAR(measured(scene, Landing::height, start, ray, 1), by_height, 0.02 * std::abs(by_height));
        }
}

// The paper's step overshoots where the sun is low: its factor passes -1.
TEST(SplatLanding, UnderALowSunThePapersStepDivergesAndTheReportSaysSo) {
    const Scene scene(flat_ground, 10);
    EXPECT_GT(scene.error(8, Landing::distance), scene.error(2, Landing::distance));
    SplatSettings s = splat_settings(sea, 100, 100, 10);
    s.options.landing = Landing::distance;
    SplatReport report;
    const Surface surface(sea, {});
    const FloorMap map = splat_map(s, surface, &report);
    EXPECT_EQ(report.vertices, 100 * 100);
    EXPECT_EQ(report.not_converged, report.vertices);
    EXPECT_GT(report.last_step_m, s.floor.plan.pitch_m.x);
    EXPECT_LT(map.ledger.closure(), 1e-6);
    s.options.landing = Landing::height;
    splat_map(s, surface, &report);
    EXPECT_EQ(report.not_converged, 0);
    EXPECT_EQ(report.missed, 0);
}

// Over ground between walls light of the edge leaves the light's image: counted, and outside.
TEST(SplatLanding, LightThatLeavesTheImageIsCountedAndOutside) {
    SplatSettings s = splat_settings(sea, 100, 100, 30);
    Field<float> bed(sea.nx, sea.ny);
    bed.fill(-1.0F);
    s.bed_m = std::make_shared<Field<float>>(std::move(bed));
    SplatReport report;
    const FloorMap map = splat_map(s, Surface(sea, {Side::wall, Side::wall}), &report);
    EXPECT_GT(report.missed, 500);
    EXPECT_LT(report.missed, 2500);
    EXPECT_GT(map.ledger.outside_w, 0.05 * map.ledger.incident_w);
    EXPECT_LT(map.ledger.closure(), 1e-6);
}

}  // namespace
}  // namespace waterlight
