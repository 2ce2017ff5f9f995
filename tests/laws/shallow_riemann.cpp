// Ten million pairs of states at a face, random and adversarial, in both precisions.
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

#include "sim/kernels/shallow_water.hpp"
#include "tests/support/shallow_runs.hpp"

namespace waterlight::testing {
namespace {

using f32::hll_flux;
using f32::hll_speeds;
using f32::shallow_flux;
using f64::hll_flux;
using f64::hll_speeds;
using f64::shallow_flux;

template <class Real>
struct Kernels;
template <>
struct Kernels<float> {
    using Water = f32::FaceWater;
    using Flux = f32::FaceFlux;
};
template <>
struct Kernels<double> {
    using Water = f64::FaceWater;
    using Flux = f64::FaceFlux;
};

/// Values to draw from, of which a share are the worst that there are.
template <class Real>
struct Deck {
    std::vector<Real> depth, froude, fall;

    static constexpr std::size_t size = 1 << 14;

    Deck() {
        using Limits = std::numeric_limits<Real>;
        RandomStream random(11, sizeof(Real));
        const std::array<Real, 8> depths{0,           0,           0,        Limits::denorm_min(), Limits::min(),
                                         Real(1e-12), Real(1e-12), Real(1e4)};
        const std::array<Real, 8> froudes{0, 0, 1, -1, 2, -2, 100, -100};
        for (std::size_t n = 0; n < size; ++n) {
            depth.push_back(n % 4 == 0 ? depths[n / 4 % 8] : static_cast<Real>(power_of_ten(random, -12, 4)));
            froude.push_back(n % 4 == 0   ? froudes[n / 4 % 8]
                             : n % 4 == 1 ? static_cast<Real>(random.uniform(-100, 100))
                                          : static_cast<Real>(random.uniform(-2, 2)));
            const double step = power_of_ten(random, -12, 4);
            fall.push_back(n % 4 == 0 ? 0 : static_cast<Real>(n % 4 == 1 ? -step : step));
        }
    }
};

/// Water on both sides of a face.
template <class Real>
struct Pair {
    typename Kernels<Real>::Water low, high;
};

template <class Real>
Pair<Real> draw(const Deck<Real>& deck, std::uint64_t n) {
    const std::uint64_t a = mix_bits(n), b = mix_bits(a);
    const auto pick = [&](const std::vector<Real>& from, std::uint64_t bits) { return from[bits % Deck<Real>::size]; };
    Real h_low = pick(deck.depth, a), h_high = pick(deck.depth, a >> 14);
    if (n % 16 == 0) h_high = h_low;
    if (n % 16 == 1) h_high = h_low * (1 + std::numeric_limits<Real>::epsilon());
    const Real scale_low = std::sqrt(Real(g) * std::max(h_low, n % 2 ? h_high : h_low));
    const Real scale_high = std::sqrt(Real(g) * std::max(h_high, n % 4 < 2 ? h_low : h_high));
    const Real fall = pick(deck.fall, a >> 28);
    return {{fall, h_low, pick(deck.froude, b) * scale_low, pick(deck.froude, b >> 14) * scale_low},
            {0, h_high, pick(deck.froude, b >> 28) * scale_high, pick(deck.froude, b >> 42) * scale_high}};
}

template <class Real>
Pair<Real> mirrored(const Pair<Real>& p) {
    return {{p.high.e, p.high.h, -p.high.u, p.high.v}, {p.low.e, p.low.h, -p.low.u, p.low.v}};
}

template <class Flux>
bool finite(const Flux& f) {
    return std::isfinite(f.mass) && std::isfinite(f.push_low) && std::isfinite(f.push_high) && std::isfinite(f.along);
}

template <class Flux>
bool nothing(const Flux& f) {
    return f.mass == 0 && f.push_low == 0 && f.push_high == 0 && f.along == 0;
}

/// What a flux of mass, and one of momentum, could be at most: the scale of rounding.
template <class Real>
std::array<double, 2> scales(const Pair<Real>& p) {
    const double a = std::abs(p.low.u) + std::sqrt(g * p.low.h), b = std::abs(p.high.u) + std::sqrt(g * p.high.h);
    const double fastest = a + b + std::sqrt(g * p.low.h) + std::sqrt(g * p.high.h);
    const double mass = (double(p.low.h) + p.high.h) * fastest;
    return {mass, mass * fastest};
}

/// Laws, and how many pairs break each.
struct Broken {
    std::int64_t finite = 0, star = 0, star_flux = 0, dry = 0, mirror = 0, balance = 0;
    std::uint64_t example = 0;
    Broken& operator+=(const Broken& b) {
        finite += b.finite, star += b.star, star_flux += b.star_flux, dry += b.dry;
        mirror += b.mirror, balance += b.balance;
        example = b.example ? b.example : example;
        return *this;
    }
};
#pragma omp declare reduction(+ : Broken : omp_out += omp_in)

/// The depth between the waves of two depths over one ground: positive, and what the flux of mass says.
template <class Real>
void judge_star(const Pair<Real>& p, Broken& broken) {
    const auto [slow, fast] = hll_speeds(p.low, p.high, Real(g));
    const auto flux = hll_flux(p.low, p.high, p.high.h - p.low.h, Real(g));
    broken.finite += !finite(flux);
    broken.dry += (p.low.h == 0 && flux.mass > 0) || (p.high.h == 0 && flux.mass < 0);
    if (!(fast - slow > 1e-15)) return;
    // fast hR - slow hL + qL - qR, free of cancellation.
    const double in_high = double(p.high.h) * (fast - p.high.u), in_low = double(p.low.h) * (p.low.u - slow);
    const double star = (in_high + in_low) / (double(fast) - slow);
    const bool wet = std::max(p.low.h, p.high.h) > 1e-30;
    broken.star += !(in_high >= 0 && in_low >= 0 && (star > 0 || !wet));
    const double through = double(p.low.h) * p.low.u + slow * (star - p.low.h);
    broken.star_flux +=
        !(std::abs(flux.mass - through) <= 20 * std::numeric_limits<Real>::epsilon() * scales(p)[0] + 1e-30);
}

template <class Real>
void judge(const Pair<Real>& p, Broken& broken) {
    const auto flux = shallow_flux(p.low, p.high, Real(g));
    broken.finite += !finite(flux);
    broken.dry += (p.low.h == 0 && flux.mass > 0) || (p.high.h == 0 && flux.mass < 0);
    broken.dry += p.low.h == 0 && p.high.h == 0 && !nothing(flux);
    const auto [mass, momentum] = scales(p);
    const auto same = [&](Real a, Real b, double scale) {
        return std::abs(double(a) - b) <= 20 * std::numeric_limits<Real>::epsilon() * scale + 1e-30;
    };
    const Pair<Real> m = mirrored(p);
    const auto back = shallow_flux(m.low, m.high, Real(g));
    broken.mirror += !(same(flux.mass, -back.mass, mass) && same(flux.push_low, back.push_high, momentum) &&
                       same(flux.push_high, back.push_low, momentum) &&
                       same(flux.along, -back.along, mass * (std::abs(p.low.v) + std::abs(p.high.v))));
    // Level water at rest, whatever the two depths: not even rounding.
    typename Kernels<Real>::Water low = p.low, high = p.high;
    low.e = high.e;
    low.u = high.u = low.v = high.v = 0;
    broken.balance += !nothing(shallow_flux(low, high, Real(g)));
}

template <class Real>
class ShallowRiemann : public ::testing::Test {};
using Precisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(ShallowRiemann, Precisions);

TYPED_TEST(ShallowRiemann, TenMillionPairs) {
    const Deck<TypeParam> deck;
    Broken broken;
#pragma omp parallel for num_threads(2) reduction(+ : broken)
    for (std::uint64_t n = 1; n <= 10'000'000; ++n) {
        const Pair<TypeParam> p = draw(deck, n);
        Broken here;
        judge(p, here);
        judge_star(p, here);
        const bool any = here.finite || here.star || here.star_flux || here.dry || here.mirror || here.balance;
        here.example = any ? n : 0;
        broken += here;
    }
    const Pair<TypeParam> p = draw(deck, broken.example);
    SCOPED_TRACE(::testing::Message() << "as pair " << broken.example << ": low h " << p.low.h << ", u " << p.low.u
                                      << "; high h " << p.high.h << ", u " << p.high.u << "; fall " << p.low.e);
    EXPECT_EQ(broken.finite, 0) << "fluxes that are not finite";
    EXPECT_EQ(broken.star, 0) << "depths between the waves that are not positive";
    EXPECT_EQ(broken.star_flux, 0) << "fluxes of mass that are not those of the depth between the waves";
    EXPECT_EQ(broken.dry, 0) << "dry sides that give water";
    EXPECT_EQ(broken.mirror, 0) << "fluxes that change in a mirror";
    EXPECT_EQ(broken.balance, 0) << "fluxes between water at rest";
}

TYPED_TEST(ShallowRiemann, EqualStatesGiveTheirOwnFlux) {
    using Real = TypeParam;
    const Deck<Real> deck;
    for (std::uint64_t n = 0; n < 200'000; ++n) {
        Pair<Real> p = draw(deck, n);
        p.high = p.low;
        const auto flux = shallow_flux(p.low, p.high, Real(g));
        const double h = p.low.h, u = p.low.u, v = p.low.v;
        const auto [mass, momentum] = scales(p);
        const double rounding = 8 * std::numeric_limits<Real>::epsilon();
        ASSERT_NEAR(flux.mass, h * u, rounding * mass + 1e-30);
        ASSERT_NEAR(flux.push_low, h * u * u, rounding * momentum + 1e-30);
        ASSERT_NEAR(flux.push_high, h * u * u, rounding * momentum + 1e-30);
        ASSERT_NEAR(flux.along, h * u * v, rounding * (momentum + mass * std::abs(v)) + 1e-30);
    }
}

/// On flat ground, where water runs apart or over dry ground, the flux of mass runs as in the exact solution of
/// Riemann's problem, but for fluxes below 1.5 % of what the waves could carry (measured: 1.1 %). Where jumps stand
/// near the face HLL's one mean state does not know on which side of it they run.
TYPED_TEST(ShallowRiemann, MassRunsAsInTheExactSolution) {
    using Real = TypeParam;
    const Deck<Real> deck;
    int clear = 0;
    double worst = 0;
    for (std::uint64_t n = 0; n < 200'000; ++n) {
        const Pair<Real> p = draw(deck, n);
        if (p.low.h < 1e-15 && p.high.h < 1e-15) continue;
        const RiemannProblem exact{p.low.h, p.high.h, p.low.u, p.high.u, {0, 0}};
        const auto middle = exact.middle();
        if (!std::isnan(middle.left_shock_m_s) || !std::isnan(middle.right_shock_m_s)) continue;
        const ShallowState at = exact.exact(0, 0, 1);
        const double expected = at.depth_m * at.velocity_m_s.x;
        const double found = hll_flux(p.low, p.high, p.high.h - p.low.h, Real(g)).mass;
        if (expected * found < 0) worst = std::max(worst, std::abs(expected) / scales(p)[0]);
        clear += std::abs(expected) > 0.015 * scales(p)[0] ? 1 : 0;
    }
    EXPECT_GT(clear, 10'000);
    EXPECT_LT(worst, 0.015);
}

}  // namespace
}  // namespace waterlight::testing
