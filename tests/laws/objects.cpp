// What a ray meets among objects: exact shapes against geometry worked out by hand, meshes against exact shapes.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "caustics/objects/object_set.hpp"
#include "sim/error.hpp"

namespace waterlight {
namespace {

using std::numbers::pi;

PlacedObjects placed(Object object, double time_s = 0) {
    return {std::make_shared<ObjectSet>(std::vector<Object>{std::move(object)}), time_s};
}

/// A sphere of triangles.
Mesh globe(double radius_m, int rings, bool smooth) {
    Mesh mesh;
    const int around = 2 * rings;
    mesh.corners_m.push_back({0, 0, radius_m});
    for (int j = 1; j < rings; ++j)
        for (int i = 0; i < around; ++i) {
            const double polar = pi * j / rings, azimuth = 2 * pi * i / around;
            mesh.corners_m.push_back(radius_m * glm::dvec3{std::sin(polar) * std::cos(azimuth),
                                                           std::sin(polar) * std::sin(azimuth), std::cos(polar)});
        }
    mesh.corners_m.push_back({0, 0, -radius_m});
    const int last = static_cast<int>(mesh.corners_m.size()) - 1;
    const auto at = [&](int i, int j) { return 1 + (j - 1) * around + i % around; };
    for (int i = 0; i < around; ++i) {
        mesh.triangles.push_back({0, at(i, 1), at(i + 1, 1)});
        for (int j = 1; j + 1 < rings; ++j) {
            mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
        }
        mesh.triangles.push_back({last, at(i + 1, rings - 1), at(i, rings - 1)});
    }
    if (smooth)
        for (const glm::dvec3& p : mesh.corners_m) mesh.normals.push_back(glm::normalize(p));
    return mesh;
}

TEST(Objects, ASphereIsMetWhereGeometrySaysToRounding) {
    Object ball{.name = "ball", .shape = Sphere{0.5}, .centre_m = {10, -3, 2}};
    const PlacedObjects objects = placed(ball);
    for (const double off : {0.0, 0.1, 0.3, 0.499999}) {
        const Ray down{{10 + off, -3, 50}, {0, 0, -1}};
        const auto hit = objects.first_hit(down);
        ASSERT_TRUE(hit) << off;
        const double height = std::sqrt(0.25 - off * off);
        EXPECT_NEAR(hit->distance_m, 48 - height, 1e-10);
        EXPECT_NEAR(glm::length(hit->normal - glm::dvec3{off / 0.5, 0, height / 0.5}), 0, 1e-8);
        // From there on through the inside, to the other side.
        const auto out = objects.first_hit({down.at(hit->distance_m), {0, 0, -1}});
        if (off < 0.49) {
            ASSERT_TRUE(out) << off;
            EXPECT_NEAR(out->distance_m, 2 * height, 1e-9);
            EXPECT_FALSE(out->enters({{}, {0, 0, -1}}));
        }
    }
    EXPECT_FALSE(objects.first_hit({{10.50001, -3, 50}, {0, 0, -1}}));
    EXPECT_FALSE(objects.first_hit({{10, -3, 50}, {0, 0, 1}}));
    EXPECT_TRUE(objects.clear({0, 0, 0}, {5, 5, 5}));
    EXPECT_FALSE(objects.clear({10, -3, 0}, {10, -3, 9}));
    EXPECT_TRUE(objects.clear({10, -3, 0}, {10, -3, 1.5})) << "ends on the ball";
}

TEST(Objects, ATurnedBoxIsMetAtItsFaces) {
    Object box{.name = "box", .shape = Box{{2, 4, 6}}, .centre_m = {1, 1, 1}, .rotation_deg = {0, 0, 90}};
    const PlacedObjects objects = placed(box);
    // Turned, it is 4 long along x.
    EXPECT_NEAR(objects.first_hit({{9, 1, 1}, {-1, 0, 0}})->distance_m, 6, 1e-12);
    EXPECT_NEAR(objects.first_hit({{1, 9, 1}, {0, -1, 0}})->distance_m, 7, 1e-12);
    EXPECT_NEAR(objects.first_hit({{1, 1, 9}, {0, 0, -1}})->distance_m, 5, 1e-12);
    EXPECT_NEAR(objects.first_hit({{9, 1, 1}, {-1, 0, 0}})->normal.x, 1, 1e-12);
    EXPECT_NEAR(objects.low_m().x, -1, 1e-12);
    EXPECT_NEAR(objects.high_m().z, 4, 1e-12);
}

TEST(Objects, RaysCrossARingAndACupAsOftenAsTheirSectionsSay) {
    const auto crossings = [](const PlacedObjects& objects, Ray ray) {
        std::vector<double> all;
        double gone = 0;
        while (const auto hit = objects.first_hit(ray)) {
            gone += hit->distance_m;
            all.push_back(gone);
            EXPECT_EQ(hit->enters(ray), all.size() % 2 == 1);
            ray.from_m = ray.at(hit->distance_m);
        }
        return all;
    };
    Object ring{.name = "ring", .shape = Ring{0.4, 0.5, 0.2}, .centre_m = {0, 0, 0.1}};
    const std::vector<double> ring_met = crossings(placed(ring), {{-2, 0, 0.1}, {1, 0, 0}});
    ASSERT_EQ(ring_met.size(), 4U);
    constexpr std::array ring_radii{-.5, -.4, .4, .5}, cup_radii{-.35, -.32, .32, .35};
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(ring_met[k], 2 + ring_radii[k], 1e-9);
    EXPECT_TRUE(crossings(placed(ring), {{0, 0, 5}, {0, 0, -1}}).empty()) << "through the hole";

    Object cup{.name = "cup", .shape = Cup{0.3, 0.4, 1, 0.03, 0.05}};
    const std::vector<double> level = crossings(placed(cup), {{-2, 0, 0.5}, {1, 0, 0}});
    ASSERT_EQ(level.size(), 4U);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(level[k], 2 + cup_radii[k], 1e-9);
    const std::vector<double> down = crossings(placed(cup), {{0.1, 0, 5}, {0, 0, -1}});
    ASSERT_EQ(down.size(), 2U);
    EXPECT_NEAR(down[0], 4.95, 1e-9);
    EXPECT_NEAR(down[1], 5, 1e-9);
    cup.rotation_deg = {180, 0, 0};
    cup.centre_m.z = 1;
    EXPECT_NEAR(crossings(placed(cup), {{0.1, 0, 5}, {0, 0, -1}}).at(0), 4, 1e-9) << "upside down, base up";
}

TEST(Objects, AMeshComesToTheShapeItStandsForAsItsTrianglesShrink) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    std::vector<Ray> rays;
    for (int k = 0; k < 2000; ++k) {
        const glm::dvec3 from = 3.0 * glm::normalize(glm::dvec3{normal(random), normal(random), normal(random)});
        const glm::dvec3 to = 0.4 * glm::normalize(glm::dvec3{normal(random), normal(random), normal(random)});
        rays.push_back({from, glm::normalize(to - from)});
    }
    const PlacedObjects exact = placed({.name = "ball", .shape = Sphere{0.5}});
    double last = 0;
    for (const int rings : {16, 32, 64}) {
        const PlacedObjects mesh = placed({.name = "globe", .shape = globe(0.5, rings, true)});
        double worst = 0, worst_normal = 0;
        for (const Ray& ray : rays) {
            const auto a = exact.first_hit(ray), b = mesh.first_hit(ray);
            ASSERT_TRUE(a && b);
            worst = std::max(worst, std::abs(a->distance_m - b->distance_m));
            worst_normal = std::max(worst_normal, glm::length(a->normal - b->normal));
        }
        if (last > 0) {
            EXPECT_NEAR(last / worst, 4, 1) << rings << ": second order";
        }
        last = worst;
        EXPECT_LT(worst_normal, 0.2 * std::pow(16.0 / rings, 2));
    }
}

TEST(Objects, ALargeMeshHasNoHoles) {
    const PlacedObjects globe_m = placed({.name = "globe", .shape = globe(2, 200, false), .centre_m = {300, -200, 10}});
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (int k = 0; k < 50000; ++k) {
        const glm::dvec3 d = glm::normalize(glm::dvec3{normal(random), normal(random), normal(random)});
        ASSERT_TRUE(globe_m.first_hit({{300, -200, 10}, d})) << "from the inside, ray " << k;
    }
}

TEST(Objects, AnObjectIsWhereItsPathSays) {
    Object ball{.name = "ball", .shape = Sphere{0.5}};
    ball.path = {{1, {0, 0, 0}}, {3, {4, 0, 2}}};
    EXPECT_EQ(ball.centre_at(0), glm::dvec3(0, 0, 0));
    EXPECT_EQ(ball.centre_at(2), glm::dvec3(2, 0, 1));
    EXPECT_EQ(ball.centre_at(9), glm::dvec3(4, 0, 2));
    EXPECT_NEAR(placed(ball, 2).first_hit({{2, 0, 9}, {0, 0, -1}})->distance_m, 7.5, 1e-12);
}

TEST(Objects, DispersionIsThatOfTheAbbeNumber) {
    const Material glass{.type = Material::Type::glass, .index = 1.5168, .abbe_number = 64.17};
    EXPECT_NEAR(glass.index_at(587.5618), 1.5168, 1e-12);
    EXPECT_NEAR((1.5168 - 1) / (glass.index_at(486.1327) - glass.index_at(656.2725)), 64.17, 1e-9);
    // Schott's N-BK7, by its data sheet: 1.52238 at F, 1.51432 at C.
    EXPECT_NEAR(glass.index_at(486.1327), 1.52238, 2e-4);
    EXPECT_NEAR(glass.index_at(656.2725), 1.51432, 2e-4);
}

TEST(Objects, WhatCannotBeIsRefusedByName) {
    const auto message = [](Object object) {
        try {
            ObjectSet({std::move(object)});
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("taken");
    };
    EXPECT_EQ(message({.name = "b", .shape = Sphere{-1}}), "object \"b\": radius is -1; allowed: above 0");
    EXPECT_EQ(message({.name = "r", .shape = Ring{0.5, 0.4, 1}}),
              "object \"r\": outer radius is 0.4 m; allowed: above the inner one, 0.5 m");
    Mesh open = globe(1, 4, false);
    open.triangles.pop_back();
    EXPECT_NE(message({.name = "m", .shape = open}).find("object \"m\": its mesh is not closed"), std::string::npos);
    Object back{.name = "p"};
    back.path = {{1, {}}, {1, {}}};
    EXPECT_NE(message(back).find("in order of time"), std::string::npos);
    EXPECT_EQ(message({.name = "g", .material = {.index = 0.9}}), "object \"g\": index is 0.9; allowed: 1 or more");
}

}  // namespace
}  // namespace waterlight
