// Every exact state solves the shallow-water equations over its own ground: what is left of them, by central
// differences at random places, falls with the square of the step, and to nothing in the limit.
#include "sim/shallow_exact.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "sim/error.hpp"
#include "sim/random.hpp"

namespace waterlight::testing {
namespace {

using std::numbers::pi;

struct Place {
    double x, y, t;
};

/// What the three equations leave, and the size of their terms.
struct Residual {
    std::array<double, 3> left{0, 0, 0};
    std::array<double, 3> size{0, 0, 0};
};

template <class State>
Residual residual(const State& state, Place p, double step, double g) {
    const auto conserved = [&](double x, double y, double t) {
        const ShallowState s = state.exact(x, y, t);
        return std::array{s.depth_m, s.depth_m * s.velocity_m_s.x, s.depth_m * s.velocity_m_s.y};
    };
    const auto flux = [&](double x, double y, int axis) {
        const ShallowState s = state.exact(x, y, p.t);
        const glm::dvec2 u = s.velocity_m_s;
        const double across = axis == 0 ? u.x : u.y;
        const double push = 0.5 * g * s.depth_m * s.depth_m;
        return std::array{s.depth_m * across, s.depth_m * across * u.x + (axis == 0 ? push : 0),
                          s.depth_m * across * u.y + (axis == 1 ? push : 0)};
    };
    const double depth = state.exact(p.x, p.y, p.t).depth_m;
    const auto before = conserved(p.x, p.y, p.t - step), after = conserved(p.x, p.y, p.t + step);
    const auto west = flux(p.x - step, p.y, 0), east = flux(p.x + step, p.y, 0);
    const auto south = flux(p.x, p.y - step, 1), north = flux(p.x, p.y + step, 1);
    const std::array ground{0.0, g * depth * (state.bed(p.x + step, p.y) - state.bed(p.x - step, p.y)),
                            g * depth * (state.bed(p.x, p.y + step) - state.bed(p.x, p.y - step))};
    // Terms that all vanish are judged against a change by one depth over a metre.
    Residual r;
    r.size = {depth * std::sqrt(g * depth), g * depth * depth, g * depth * depth};
    for (std::size_t n = 0; n < 3; ++n) {
        const std::array terms{after[n] - before[n], east[n] - west[n], north[n] - south[n], ground[n]};
        for (const double term : terms) {
            r.left[n] += term / (2 * step);
            r.size[n] += std::abs(term) / (2 * step);
        }
    }
    return r;
}

/// At 400 random places in a box, as far as `inside` accepts them.
template <class State>
void expect_solution(
    const State& state, Place low, Place high, double step,
    const std::function<bool(Place)>& inside = [](Place) { return true; }) {
    RandomStream random(1, 0);
    std::array<double, 3> coarse{}, fine{}, limit{}, size{};
    int accepted = 0;
    for (int n = 0; n < 400; ++n) {
        const Place p{random.uniform(low.x, high.x), random.uniform(low.y, high.y), random.uniform(low.t, high.t)};
        if (!inside(p)) continue;
        ++accepted;
        const Residual a = residual(state, p, step, state.gravity_m_s2);
        const Residual b = residual(state, p, 0.5 * step, state.gravity_m_s2);
        for (std::size_t k = 0; k < 3; ++k) {
            coarse[k] += a.left[k] * a.left[k];
            fine[k] += b.left[k] * b.left[k];
            limit[k] += std::pow((4 * b.left[k] - a.left[k]) / 3, 2);
            size[k] += b.size[k] * b.size[k];
        }
    }
    ASSERT_GE(accepted, 100);
    for (std::size_t k = 0; k < 3; ++k) {
        SCOPED_TRACE("equation " + std::to_string(k));
        EXPECT_LE(limit[k], 1e-12 * size[k]);
        const bool only_rounding = coarse[k] <= 1e-20 * size[k];
        const double order = 0.5 * std::log2(coarse[k] / fine[k]);
        EXPECT_TRUE(only_rounding || (order > 1.95 && order < 2.05)) << "order " << order;
    }
}

/// Wet at p and for 0.02 around it, by the corners of a cross in x, y and t.
template <class State>
std::function<bool(Place)> wet(const State& state) {
    return [state](Place p) {
        for (const double d : {-0.02, 0.02})
            if (state.exact(p.x + d, p.y, p.t).depth_m <= 0 || state.exact(p.x, p.y + d, p.t).depth_m <= 0 ||
                state.exact(p.x, p.y, p.t + d).depth_m <= 0)
                return false;
        return true;
    };
}

TEST(ShallowExact, ThackersBowlsSolveTheEquations) {
    for (const double g : {9.81, 3.7}) {
        ThackerPlanar planar;
        planar.gravity_m_s2 = g;
        expect_solution(planar, {0.5, 0.5, 0}, {3.5, 3.5, planar.period_s()}, 2e-3, wet(planar));
        ThackerRadial radial;
        radial.gravity_m_s2 = g;
        expect_solution(radial, {0.8, 0.8, 0}, {3.2, 3.2, radial.period_s()}, 2e-3, wet(radial));
    }
}

TEST(ShallowExact, TravellingVortexSolvesTheEquations) {
    expect_solution(TravellingVortex{}, {-3, -3, 0}, {3, 3, 2}, 4e-3);
    expect_solution(TravellingVortex{.h0_m = 1, .speed_m_s = 0.3, .direction_deg = 200, .gravity_m_s2 = 5}, {-3, -3, 0},
                    {1, 1, 1}, 4e-3);
}

TEST(ShallowExact, FansOfDamBreaksSolveTheEquations) {
    // Well inside the fans, whose ends are kinks: at -c and 2c of the reservoir over dry ground, -c and u - c of the
    // middle state over wet ground.
    RiemannProblem dry{.left_depth_m = 1, .right_depth_m = 0, .at_m = {0, 0}, .direction_deg = 30};
    RiemannProblem wet_bed{.left_depth_m = 1, .right_depth_m = 0.2, .at_m = {0, 0}, .direction_deg = 30};
    const double c = std::sqrt(dry.gravity_m_s2);
    const auto between = [](double low, double high) {
        return [low, high](Place p) {
            const double xi = (p.x * std::cos(pi / 6) + p.y * std::sin(pi / 6)) / p.t;
            return xi > low && xi < high;
        };
    };
    expect_solution(dry, {-5, -5, 2}, {12, 12, 3}, 4e-3, between(-0.9 * c, 1.6 * c));
    const auto middle = wet_bed.middle();
    const double end = middle.velocity_m_s - std::sqrt(wet_bed.gravity_m_s2 * middle.depth_m);
    expect_solution(wet_bed, {-7, -7, 2}, {4, 4, 3}, 4e-3, between(-0.9 * c, end - 0.1));
}

TEST(ShallowExact, FlowOverTheBumpSolvesTheEquations) {
    for (const SteadyBump& bump : {subcritical_bump(), transcritical_bump(), jump_bump()}) {
        const double jump = bump.flow().jump_m;
        expect_solution(bump, {8.01, 0, 0}, {11.99, 1, 1}, 2e-3,
                        [jump](Place p) { return std::isnan(jump) || std::abs(p.x - jump) > 0.01; });
    }
}

TEST(ShallowExact, ThackersPlaneSurfaceIsTheFormulaInUse) {
    const ThackerPlanar state;
    const double w = std::sqrt(2 * 9.81 * 0.1);
    for (const double t : {0.0, 0.7, 5.0}) {
        for (const auto& [x, y] : {std::pair{0.3, 0.2}, {-0.4, 0.6}, {1.2, -0.3}, {-1.4, -1.4}}) {
            const ShallowState found = state.exact(2 + x, 2 + y, t);
            const double h = std::max(
                0.0, 0.5 * 0.1 * (2 * x * std::cos(w * t) + 2 * y * std::sin(w * t) - 0.5) + 0.1 * (1 - x * x - y * y));
            EXPECT_NEAR(found.depth_m, h, 1e-15);
            if (h <= 0) continue;
            EXPECT_NEAR(found.velocity_m_s.x, -0.5 * w * std::sin(w * t), 1e-14);
            EXPECT_NEAR(found.velocity_m_s.y, 0.5 * w * std::cos(w * t), 1e-14);
        }
    }
}

TEST(ShallowExact, BowlsAreWhatTheyWereAfterAPeriod) {
    const ThackerPlanar planar;
    const ThackerRadial radial;
    for (const double x : {1.7, 2.0, 2.4}) {
        EXPECT_NEAR(planar.exact(x, 2.1, 0.3).depth_m, planar.exact(x, 2.1, 0.3 + planar.period_s()).depth_m, 1e-14);
        EXPECT_NEAR(radial.exact(x, 2.1, 0.3).depth_m, radial.exact(x, 2.1, 0.3 + radial.period_s()).depth_m, 1e-14);
    }
    // The shore of the swinging paraboloid is where it was asked to be.
    EXPECT_GT(radial.exact(2.799999, 2, 0).depth_m, 0);
    EXPECT_EQ(radial.exact(2.800001, 2, 0).depth_m, 0);
}

TEST(ShallowExact, TravellingVortexIsTheFormulaInUse) {
    const TravellingVortex state;
    const double t = 1.3, x = 0.2, y = -0.4;
    const double rx = x + 1 - t / std::sqrt(2), ry = y + 1 - t / std::sqrt(2);
    const double f = 2 / (2 * pi) * std::exp((1 - rx * rx - ry * ry) / 2);
    const ShallowState found = state.exact(x, y, t);
    EXPECT_NEAR(found.depth_m, 2 - f * f / (2 * 9.81), 1e-15);
    EXPECT_NEAR(found.velocity_m_s.x, 1 / std::sqrt(2) - f * ry, 1e-15);
    EXPECT_NEAR(found.velocity_m_s.y, 1 / std::sqrt(2) + f * rx, 1e-15);
    EXPECT_EQ(state.bed(x, y), -2);
}

TEST(ShallowExact, HeadIsKeptOverTheBump) {
    for (const SteadyBump& bump : {subcritical_bump(), transcritical_bump(), jump_bump()}) {
        const auto flow = bump.flow();
        for (double x = 0; x <= 25; x += 0.05) {
            const ShallowState s = bump.exact(x, 0, 0);
            const double u = s.velocity_m_s.x;
            const double head = s.depth_m + u * u / (2 * bump.gravity_m_s2) + bump.bed(x, 0);
            EXPECT_NEAR(head, x > flow.jump_m ? flow.downstream_head_m : flow.upstream_head_m, 1e-14 * head * 10);
            EXPECT_NEAR(s.depth_m * u, bump.discharge_m2_s, 1e-14);
        }
    }
}

TEST(ShallowExact, BumpHasItsThreeRegimes) {
    const auto froude = [](const SteadyBump& bump, double x) {
        const ShallowState s = bump.exact(x, 0, 0);
        return s.velocity_m_s.x / std::sqrt(bump.gravity_m_s2 * s.depth_m);
    };
    const SteadyBump slow = subcritical_bump();
    EXPECT_EQ(slow.flow().regime, BumpRegime::subcritical);
    EXPECT_NEAR(slow.exact(25, 0, 0).depth_m, 2, 1e-14);
    EXPECT_LT(froude(slow, 10), 1);

    const SteadyBump fast = transcritical_bump();
    EXPECT_EQ(fast.flow().regime, BumpRegime::transcritical);
    const SteadyBump jump = jump_bump();
    EXPECT_EQ(jump.flow().regime, BumpRegime::transcritical_with_jump);
    for (const SteadyBump& bump : {fast, jump}) {
        EXPECT_NEAR(froude(bump, 10), 1, 1e-13);
        EXPECT_LT(froude(bump, 9.99), 1);
        EXPECT_GT(froude(bump, 10.01), 1);
    }
    EXPECT_GT(froude(fast, 25), 1);
    EXPECT_NEAR(jump.exact(25, 0, 0).depth_m, 0.33, 1e-14);
    // By bisection of the momentum in 30 digits.
    EXPECT_NEAR(jump.flow().jump_m, 11.66561838431536, 1e-12);
}

TEST(ShallowExact, OutOfRangeIsRefused) {
    EXPECT_THROW(ThackerPlanar{.h0_m = 0}.check(), InputError);
    EXPECT_THROW(ThackerRadial{.r0_m = 1.1}.check(), InputError);
    EXPECT_THROW(TravellingVortex{.h0_m = 0.01}.check(), InputError);
    EXPECT_THROW(RiemannProblem{.left_depth_m = -1}.check(), InputError);
    EXPECT_THROW(SteadyBump{.downstream_depth_m = 0.1}.check(), InputError);
    EXPECT_THROW(ObliqueJump{.deflection_deg = 40}.check(), InputError);
    EXPECT_THROW(ObliqueJump{.speed_m_s = 3}.check(), InputError);
    for (const ShallowExact& state :
         {ShallowExact{ThackerPlanar{}}, ShallowExact{ThackerRadial{}}, ShallowExact{TravellingVortex{}},
          ShallowExact{ritter()}, ShallowExact{stoker()}, ShallowExact{jump_bump()}, ShallowExact{ObliqueJump{}}})
        EXPECT_NO_THROW(std::visit([](const auto& s) { s.check(); }, state));
}

}  // namespace
}  // namespace waterlight::testing
