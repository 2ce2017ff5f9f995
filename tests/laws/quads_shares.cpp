// The shares of small quads are those that exact areas give, whatever the quad's shape and turn.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "caustics/cell_shares.hpp"
#include "caustics/quad_batch.hpp"

namespace waterlight {
namespace {

using Quad = std::array<glm::dvec2, 4>;

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

double area_of(const Quad& q) { return 0.5 * cross(q[2] - q[0], q[3] - q[1]); }

/// Convex quads in [0, size] x [0, size] that touch its low sides' cells, either way round.
Quad random_quad(std::mt19937& random, double size) {
    std::uniform_real_distribution<double> place(0, size);
    while (true) {
        Quad q;
        for (glm::dvec2& p : q) p = {place(random), place(random)};
        bool all_left = true, all_right = true;
        for (int k = 0; k < 4; ++k) {
            const double turn = cross(q[(k + 1) % 4] - q[k], q[(k + 2) % 4] - q[(k + 1) % 4]);
            all_left = all_left && turn > 0;
            all_right = all_right && turn < 0;
        }
        if ((all_left || all_right) && std::abs(area_of(q)) > 0.05) return q;
    }
}

std::map<std::pair<int, int>, double> exact(const Quad& q) {
    std::map<std::pair<int, int>, double> shares;
    CellShares cells;
    cells.share(q, [&](int i, int j, double share) { shares[{i, j}] += share; });
    return shares;
}

TEST(QuadShares, OfTwoByTwoCellsAreExact) {
    std::mt19937 random(3);
    for (int k = 0; k < 2000; ++k) {
        const Quad q = random_quad(random, 2);
        auto expected = exact(q);
        const f64::FourParts p = f64::parts_in_four(q[0], q[1], q[2], q[3], area_of(q));
        EXPECT_NEAR(p.low_left, (expected[{0, 0}]), 1e-12);
        EXPECT_NEAR(p.low_right, (expected[{1, 0}]), 1e-12);
        EXPECT_NEAR(p.high_left, (expected[{0, 1}]), 1e-12);
        EXPECT_NEAR(p.high_right, (expected[{1, 1}]), 1e-12);
    }
}

TEST(QuadShares, OfQuadsWithLevelAndUprightSidesAreExact) {
    for (const double low : {0.0, 0.25, 1.0})
        for (const double high : {1.0, 1.5, 2.0}) {
            if (low == high) continue;
            const Quad q{{{low, low}, {high, low}, {high, high}, {low, high}}};
            auto expected = exact(q);
            const f64::FourParts p = f64::parts_in_four(q[0], q[1], q[2], q[3], area_of(q));
            EXPECT_NEAR(p.low_left, (expected[{0, 0}]), 1e-14) << low << " " << high;
            EXPECT_NEAR(p.low_right, (expected[{1, 0}]), 1e-14) << low << " " << high;
            EXPECT_NEAR(p.high_right, (expected[{1, 1}]), 1e-14) << low << " " << high;
        }
}

TEST(QuadShares, OfABatchInThreeByThreeCellsAreExactToSinglePrecision) {
    std::mt19937 random(5);
    QuadBatch batch;
    std::vector<Quad> quads;
    for (batch.count = 0; batch.count < QuadBatch::size; ++batch.count) {
        const Quad q = random_quad(random, 3);
        for (int k = 0; k < 4; ++k) {
            batch.x[k][batch.count] = static_cast<float>(q[k].x);
            batch.y[k][batch.count] = static_cast<float>(q[k].y);
        }
        batch.area[batch.count] = static_cast<float>(area_of(q));
        batch.light[batch.count] = 2;
        quads.push_back(q);
    }
    std::vector<float> shares(4 * 4 * QuadBatch::size);
    batch.share(shares.data());
    for (int i = 0; i < batch.count; ++i) {
        auto expected = exact(quads[static_cast<std::size_t>(i)]);
        for (int block = 0; block < 4; ++block)
            for (int k = 0; k < 4; ++k) {
                const std::pair cell{2 * (block % 2) + k % 2, 2 * (block / 2) + k / 2};
                EXPECT_NEAR(shares[static_cast<std::size_t>(4 * (block * QuadBatch::size + i) + k)], 2 * expected[cell],
                            2e-5);
            }
    }
}

}  // namespace
}  // namespace waterlight
