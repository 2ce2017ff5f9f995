// Riemann's problem and hydraulic jumps: the conditions of Rankine and Hugoniot, and figures in print.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "sim/random.hpp"
#include "sim/shallow_means.hpp"

namespace waterlight::testing {
namespace {

using std::numbers::pi;
constexpr double g = 9.81;

/// What a shock of this speed would make of mass and momentum between two states, against the size of the terms.
void expect_rankine_hugoniot(double h1, double u1, double h2, double u2, double speed, double tolerance) {
    const double q1 = h1 * (u1 - speed), q2 = h2 * (u2 - speed);
    EXPECT_NEAR(q1, q2, tolerance * (std::abs(q1) + h1 * std::abs(u1) + h2 * std::abs(u2)));
    const double f1 = q1 * (u1 - speed) + 0.5 * g * h1 * h1, f2 = q2 * (u2 - speed) + 0.5 * g * h2 * h2;
    EXPECT_NEAR(f1, f2, tolerance * (f1 + std::abs(q1) * (std::abs(u1) + std::abs(u2))));
}

RiemannProblem random_problem(RandomStream& random) {
    const auto depth = [&] { return random.uniform() < 0.1 ? 0 : std::pow(10, random.uniform(-6, 3)); };
    RiemannProblem p;
    p.left_depth_m = depth();
    p.right_depth_m = depth();
    const double c = std::sqrt(g * std::max(p.left_depth_m, p.right_depth_m));
    p.left_velocity_m_s = c * random.uniform(-3, 3);
    p.right_velocity_m_s = c * random.uniform(-3, 3);
    return p;
}

TEST(ShallowShocks, RandomRiemannProblemsKeepTheirInvariants) {
    RandomStream random(7, 0);
    int shocks = 0, fans = 0, dry = 0;
    for (int n = 0; n < 20000; ++n) {
        const RiemannProblem p = random_problem(random);
        const auto middle = p.middle();
        if (middle.depth_m == 0) {
            ++dry;
            const bool wet = p.left_depth_m > 0 && p.right_depth_m > 0;
            EXPECT_TRUE(!wet || p.right_velocity_m_s - p.left_velocity_m_s >=
                                    2 * (std::sqrt(g * p.left_depth_m) + std::sqrt(g * p.right_depth_m)));
            continue;
        }
        const auto expect_wave = [&](double h, double u, double speed, double side) {
            if (!std::isnan(speed)) {
                ++shocks;
                EXPECT_GT(middle.depth_m, h);
                expect_rankine_hugoniot(h, u, middle.depth_m, middle.velocity_m_s, speed, 1e-12);
            } else {
                ++fans;
                EXPECT_LE(middle.depth_m, h);
                const double before = u + side * 2 * std::sqrt(g * h);
                const double after = middle.velocity_m_s + side * 2 * std::sqrt(g * middle.depth_m);
                EXPECT_NEAR(before, after, 1e-12 * (std::abs(u) + std::abs(middle.velocity_m_s) + std::sqrt(g * h)));
            }
        };
        expect_wave(p.left_depth_m, p.left_velocity_m_s, middle.left_shock_m_s, 1);
        expect_wave(p.right_depth_m, p.right_velocity_m_s, middle.right_shock_m_s, -1);
    }
    EXPECT_GT(shocks, 5000);
    EXPECT_GT(fans, 5000);
    EXPECT_GT(dry, 1000);
}

TEST(ShallowShocks, SolutionsAreMirroredWithTheirProblem) {
    RandomStream random(8, 0);
    for (int n = 0; n < 2000; ++n) {
        RiemannProblem p = random_problem(random);
        p.at_m = {0, 0};
        RiemannProblem mirrored = p;
        std::swap(mirrored.left_depth_m, mirrored.right_depth_m);
        mirrored.left_velocity_m_s = -p.right_velocity_m_s;
        mirrored.right_velocity_m_s = -p.left_velocity_m_s;
        const double c = std::sqrt(g * std::max(p.left_depth_m, p.right_depth_m));
        const double x = c * random.uniform(-6, 6);
        const ShallowState a = p.exact(x, 0, 1), b = mirrored.exact(-x, 0, 1);
        EXPECT_NEAR(a.depth_m, b.depth_m, 1e-12 * a.depth_m);
        EXPECT_NEAR(a.velocity_m_s.x, -b.velocity_m_s.x, 1e-12 * 10 * c);
    }
}

TEST(ShallowShocks, RiemannSolutionsKeepMassAndMomentum) {
    RandomStream random(9, 0);
    for (int n = 0; n < 100; ++n) {
        RiemannProblem p = random_problem(random);
        p.at_m = {0, 0};
        const double hl = p.left_depth_m, hr = p.right_depth_m, ul = p.left_velocity_m_s, ur = p.right_velocity_m_s;
        if (hl == 0 && hr == 0) continue;
        const double reach = 12 * std::sqrt(g * std::max(hl, hr));
        const Grid grid{1000, 1, 2 * reach / 1000, 1, -reach, 0};
        const ShallowMeans means = cell_means(p, grid, 1);
        double mass = 0, momentum = 0;
        for (const double h : means.depth_m.values()) mass += h * grid.dx_m;
        for (const double q : means.discharge_x_m2_s.values()) momentum += q * grid.dx_m;
        const double ql = hl * ul, qr = hr * ur;
        const double expected_mass = reach * (hl + hr) + ql - qr;
        const double expected_momentum = reach * (ql + qr) + ql * ul - qr * ur + 0.5 * g * (hl * hl - hr * hr);
        // Two shocks, each in a cell whose mean is at worst 2e-3 of the step off.
        const double deepest = std::max({hl, hr, p.middle().depth_m});
        const double fastest = std::max({std::abs(ul), std::abs(ur), std::abs(p.middle().velocity_m_s)});
        EXPECT_NEAR(mass, expected_mass, 4e-3 * grid.dx_m * deepest);
        EXPECT_NEAR(momentum, expected_momentum, 8e-3 * grid.dx_m * deepest * fastest);
    }
}

TEST(ShallowShocks, RitterIsTheFormulaInUse) {
    const RiemannProblem dam = ritter();
    const double c = std::sqrt(g * 0.005);
    for (const double t : {1.0, 6.0}) {
        for (const double xi : {-0.99, -0.3, 0.0, 0.8, 1.9}) {
            const double x = xi * c * t;
            const ShallowState found = dam.exact(5 + x, 0, t);
            EXPECT_NEAR(found.depth_m, 4 / (9 * g) * std::pow(c - x / (2 * t), 2), 1e-16);
            EXPECT_NEAR(found.velocity_m_s.x, 2.0 / 3 * (x / t + c), 1e-15);
        }
        EXPECT_EQ(dam.exact(5 - 1.001 * c * t, 0, t).depth_m, 0.005);
        EXPECT_EQ(dam.exact(5 + 2.001 * c * t, 0, t).depth_m, 0);
    }
}

TEST(ShallowShocks, StokerHasItsFiguresInPrint) {
    const RiemannProblem dam = stoker();
    const auto middle = dam.middle();
    EXPECT_NEAR(middle.depth_m, 2.5393572e-3, 0.5e-10);
    EXPECT_NEAR(middle.velocity_m_s, 0.12727972, 0.5e-8);
    EXPECT_NEAR(middle.right_shock_m_s, 0.20996340, 0.5e-8);
    EXPECT_TRUE(std::isnan(middle.left_shock_m_s));
    EXPECT_EQ(dam.exact(5 + 0.2099 * 6, 0, 6).depth_m, middle.depth_m);
    EXPECT_EQ(dam.exact(5 + 0.2100 * 6, 0, 6).depth_m, 0.001);
}

TEST(ShallowShocks, DamsAreTurnedAsAsked) {
    RiemannProblem dam = stoker();
    dam.at_m = {1, 2};
    dam.direction_deg = 120;
    const glm::dvec2 n{std::cos(2 * pi / 3), std::sin(2 * pi / 3)};
    const glm::dvec2 at = dam.at_m + 0.3 * n + 0.7 * glm::dvec2(-n.y, n.x);
    const ShallowState found = dam.exact(at.x, at.y, 2), expected = stoker().exact(5.3, 0, 2);
    EXPECT_NEAR(found.depth_m, expected.depth_m, 1e-15);
    EXPECT_NEAR(found.velocity_m_s.x, expected.velocity_m_s.x * n.x, 1e-15);
    EXPECT_NEAR(found.velocity_m_s.y, expected.velocity_m_s.x * n.y, 1e-15);
}

TEST(ShallowShocks, JumpBehindTheBumpStands) {
    for (const double held : {0.30, 0.33, 0.35}) {
        SteadyBump bump = jump_bump();
        bump.downstream_depth_m = held;
        const auto flow = bump.flow();
        ASSERT_EQ(flow.regime, BumpRegime::transcritical_with_jump) << held;
        const ShallowState ahead = bump.exact(std::nextafter(flow.jump_m, 0), 0, 0);
        const ShallowState behind = bump.exact(std::nextafter(flow.jump_m, 25), 0, 0);
        EXPECT_GT(behind.depth_m, ahead.depth_m * 1.1);
        expect_rankine_hugoniot(ahead.depth_m, ahead.velocity_m_s.x, behind.depth_m, behind.velocity_m_s.x, 0, 1e-12);
        EXPECT_LT(flow.downstream_head_m, flow.upstream_head_m);
    }
}

TEST(ShallowShocks, ObliqueJumpHasItsFiguresInPrint) {
    const auto behind = ObliqueJump{}.behind();
    EXPECT_NEAR(behind.angle_deg, 30.02, 0.005);
    EXPECT_NEAR(behind.depth_m, 1.4997, 0.5e-4);
    EXPECT_NEAR(behind.speed_m_s, 7.952, 0.5e-3);
}

TEST(ShallowShocks, ObliqueJumpKeepsMassAndMomentumAndVelocityAlongIt) {
    for (const double deflection : {1.0, 8.95, 20.0}) {
        const ObliqueJump jump{.deflection_deg = deflection};
        jump.check();
        const double from_wall = (jump.behind().angle_deg - deflection) * pi / 180;
        const glm::dvec2 along{std::cos(from_wall), std::sin(from_wall)}, across{-along.y, along.x};
        const glm::dvec2 at = 3.0 * along;
        const auto inflow = jump.exact(at.x + 0.01 * across.x, at.y + 0.01 * across.y, 0);
        const auto behind = jump.exact(at.x - 0.01 * across.x, at.y - 0.01 * across.y, 0);
        EXPECT_NEAR(glm::dot(inflow.velocity_m_s, along), glm::dot(behind.velocity_m_s, along), 1e-12);
        expect_rankine_hugoniot(inflow.depth_m, glm::dot(inflow.velocity_m_s, across), behind.depth_m,
                                glm::dot(behind.velocity_m_s, across), 0, 1e-12);
        // Along the wall behind, towards it ahead.
        EXPECT_EQ(behind.velocity_m_s.y, 0);
        EXPECT_NEAR(std::atan2(-inflow.velocity_m_s.y, inflow.velocity_m_s.x), deflection * pi / 180, 1e-14);
        EXPECT_GT(behind.velocity_m_s.x, std::sqrt(g * behind.depth_m));
    }
}

}  // namespace
}  // namespace waterlight::testing
