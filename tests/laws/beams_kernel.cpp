// The formulas of beams and phase functions against independent geometry and quadrature.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "caustics/kernels/beams.hpp"
#include "caustics/kernels/phase.hpp"
#include "caustics/phase.hpp"
#include "caustics/water_types.hpp"

namespace waterlight {
namespace {

using glm::dvec2;
using glm::dvec3;
using std::numbers::pi;

double cross2(dvec2 a, dvec2 b) { return a.x * b.y - a.y * b.x; }

/// A triangle and three directions that diverge from it, turned at random.
struct RandomBeam {
    dvec3 v[3], d[3];
    explicit RandomBeam(std::mt19937& random) {
        std::uniform_real_distribution<double> any(-1, 1);
        const auto vector = [&] { return dvec3{any(random), any(random), any(random)}; };
        const dvec3 down = glm::normalize(vector());
        for (int i = 0; i < 3; ++i) {
            v[i] = vector();
            d[i] = down + 0.2 * vector();
        }
    }
};

TEST(BeamKernel, TheAreaPolynomialIsTheAreaOfTheSection) {
    std::mt19937 random(4);
    int tried = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const RandomBeam r(random);
        const dvec3 n = glm::normalize(glm::cross(r.v[1] - r.v[0], r.v[2] - r.v[0]));
        // Beams that run along their own triangle are discarded before they come here.
        bool steep = true;
        for (const dvec3& d : r.d)
            steep = steep && glm::dot(d, n) * glm::dot(r.d[0], n) > 0 && std::abs(glm::dot(d, n)) > .2;
        if (!steep) continue;
        ++tried;
        const f64::BeamSpace b = f64::beam_space(r.v[0], r.v[1], r.v[2], r.d[0], r.d[1], r.d[2]);
        for (const double y : {0.0, 0.3, 1.0, 2.7}) {
            dvec3 p[3];
            for (int i = 0; i < 3; ++i) p[i] = r.v[i] + r.d[i] * (y / std::abs(glm::dot(r.d[i], n)));
            const double direct = glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
            EXPECT_NEAR(f64::section_area(b.area, y), direct, 1e-11 * (1 + direct) * (1 + y * y));
        }
    }
    EXPECT_GT(tried, 50);
}

TEST(BeamKernel, BeamSpaceIsOrthonormalAndLooksAlongTheLight) {
    std::mt19937 random(5);
    const RandomBeam r(random);
    const f64::BeamSpace b = f64::beam_space(r.v[0], r.v[1], r.v[2], r.d[0], r.d[1], r.d[2]);
    EXPECT_NEAR(glm::dot(b.x, b.y), 0, 1e-14);
    EXPECT_NEAR(glm::dot(b.y, b.z), 0, 1e-14);
    EXPECT_NEAR(glm::length(b.z), 1, 1e-14);
    EXPECT_GT(glm::dot(b.y, r.d[0]), 0);
    EXPECT_NEAR(b.k1.x, -glm::length(r.v[1] - r.v[0]), 1e-14) << "x runs along v0 - v1";
    EXPECT_NEAR(b.k1.y, 0, 1e-14);
}

TEST(BeamKernel, IrradianceAcrossASlantingBeamIsThatOfItsCrossSection) {
    // Parallel light of 3 W/m2 at 50 degrees from the normal through a triangle of 2 m2 carries 6 cos(50) W.
    const double cosine = std::cos(50 * pi / 180);
    EXPECT_NEAR(f64::irradiance_across(6 * cosine, 4, cosine), 3, 1e-14);
}

f64::SectionCorner corner(const f64::BeamEdge& e, dvec2 mean, dvec3 r, double down) {
    const f64::EdgeForms f = f64::edge_forms(e, mean);
    const dvec3 ray{r.x, r.y, down};
    const dvec2 v = down * mean - dvec2(r);
    return f64::section_corner(
        {glm::dot(f.along, ray), glm::dot(f.across, ray), glm::dot(f.leads, ray), glm::dot(f.warps, ray)},
        1 / glm::dot(v, v), down, -1e9, 1e9);
}

TEST(BeamKernel, AChordThroughAParallelPrismIsExact) {
    // Against the clipping of the ray by the three side planes.
    std::mt19937 random(6);
    std::uniform_real_distribution<double> any(-1, 1);
    int inside = 0, outside = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const dvec2 travel{any(random), any(random)};
        f64::BeamEdge edge[3];
        for (f64::BeamEdge& e : edge) e = {{5 + any(random), any(random)}, travel};
        const double down = 0.3 * any(random);
        const dvec3 r{1, 0.2 * any(random), -down};
        double begin = -1e9, end = 1e9;
        const double turn = cross2(edge[1].at - edge[0].at, edge[2].at - edge[0].at);
        for (int i = 0; i < 3; ++i) {
            const dvec2 a = edge[i].at, side = edge[(i + 1) % 3].at - a;
            // Inside: turn * cross(side, place of the ray in the prism's section - a) >= 0, linear in t.
            const double rate = turn * cross2(side, dvec2(r) - down * travel), start = turn * cross2(side, -a);
            if (rate > 0) begin = std::max(begin, -start / rate);
            if (rate < 0) end = std::min(end, -start / rate);
        }
        const f64::BeamChord chord = f64::beam_chord(corner(edge[0], travel, r, down), corner(edge[1], travel, r, down),
                                                     corner(edge[2], travel, r, down), 1);
        if (begin >= end) {
            EXPECT_EQ(chord.density, 0);
            ++outside;
            continue;
        }
        ++inside;
        EXPECT_NEAR(chord.begin, begin, 1e-9);
        EXPECT_NEAR(chord.end, end, 1e-9);
        EXPECT_NEAR(chord.density * std::abs(turn), end - begin, 1e-9);
    }
    EXPECT_GT(inside, 200);
    EXPECT_GT(outside, 200);
}

TEST(BeamKernel, AWarpedBeamsChordConvergesToTheTrueOne) {
    // Sides are bilinear: the true ends solve U_i x U_j = 0. The error falls with the square of the beam's width.
    double last = 1;
    for (const double width : {0.4, 0.2, 0.1, 0.05}) {
        const dvec2 at[3] = {{4, -.3}, {4.9, .1}, {4.2, .7}}, away[3] = {{.1, -.2}, {-.15, .1}, {.05, .25}};
        f64::BeamEdge edge[3];
        dvec2 mean{0, 0};
        for (int i = 0; i < 3; ++i) {
            edge[i] = {dvec2{4.4, .15} + width * (at[i] - dvec2{4.4, .15}), dvec2{.3, .1} + width * away[i]};
            mean += edge[i].travel / 3.0;
        }
        const double down = .25;
        const dvec3 r{1, .056, -down};
        const f64::BeamChord chord = f64::beam_chord(corner(edge[0], mean, r, down), corner(edge[1], mean, r, down),
                                                     corner(edge[2], mean, r, down), 1);
        double begin = 1e9, end = -1e9;
        for (int i = 0; i < 3; ++i) {
            const f64::BeamEdge &a = edge[i], &b = edge[(i + 1) % 3];
            const auto u = [&](const f64::BeamEdge& e, double t) { return e.at + t * (down * e.travel - dvec2(r)); };
            double t = 4.75;
            for (int k = 0; k < 100; ++k) {
                const double h = 1e-6, f = cross2(u(a, t), u(b, t));
                t -= f * 2 * h / (cross2(u(a, t + h), u(b, t + h)) - cross2(u(a, t - h), u(b, t - h)));
            }
            if (glm::dot(u(a, t), u(b, t)) > 0) continue;  // crosses the line of the side, not the side
            begin = std::min(begin, t);
            end = std::max(end, t);
        }
        ASSERT_LT(begin, end);
        const double error = (std::abs(chord.begin - begin) + std::abs(chord.end - end)) / (end - begin);
        EXPECT_LT(error, 0.6 * last) << width;
        last = error;
    }
    EXPECT_LT(last, 0.01);
}

/// Over the sphere, in ln sin^2(angle / 2) and so with the forward peak resolved; `from` is the least sine^2.
template <class Phase>
double over_sphere(const Phase& phase, double from_sine2, double to_sine2) {
    const int n = 200000;
    const double low = std::log(from_sine2), step = (std::log(to_sine2) - low) / n;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        const double sine2 = std::exp(low + (i + .5) * step);
        sum += phase(sine2) * 4 * pi * sine2 * step;  // d(solid angle) = 4 pi d(sin^2)
    }
    return sum;
}

TEST(PhaseKernel, AllIsScatteredSomewhere) {
    for (const double g : {0.0, 0.5, 0.9, 0.98})
        EXPECT_NEAR(over_sphere([&](double s) { return f64::henyey_greenstein(g, 1 - 2 * s); }, 1e-12, 1), 1, 1e-6)
            << g;
    EXPECT_NEAR(over_sphere([](double s) { return f64::pure_water(1 - 2 * s); }, 1e-12, 1), 1, 1e-3);
    EXPECT_NEAR(over_sphere([](double s) { return f64::fournier_forand(1.1, 3.5835, s); }, 1e-30, 1), 1, 2e-3);
}

TEST(PhaseKernel, FournierForandSendsBackWhatItsAuthorsTabulate) {
    // Backscatter fractions of Fournier & Jonasz (1999); Petzold's average is 0.0183.
    const auto back = [](double n, double slope) {
        return over_sphere([&](double s) { return f64::fournier_forand(n, slope, s); }, 0.5, 1);
    };
    EXPECT_NEAR(back(1.10, 3.5835) / 0.0183, 1, 0.01);
    EXPECT_NEAR(back(1.08, 3.483) / 0.01, 1, 0.01);
    EXPECT_NEAR(back(1.175, 4.065) / 0.1, 1, 0.01);
}

TEST(WaterTypes, ScatterBackWhatWasMeasured) {
    for (const WaterType& water : water_types) {
        const auto phase = [&](double s) {
            return water.phase.type == Phase::Type::pure_water
                       ? f64::pure_water(1 - 2 * s)
                       : f64::fournier_forand(water.phase.index, water.phase.slope, s);
        };
        EXPECT_NEAR(over_sphere(phase, 0.5, 1) / water.backscattered, 1, 0.01) << water.name;
    }
}

TEST(WaterTypes, FournierForandSendsBackWhatTheOceanOpticsWebBookTabulates) {
    // Its page "The Fournier-Forand Phase Function", table 1: index, slope, backscattered part; digits as printed
    // there.
    struct Row {
        double index, slope, back, tolerance;
    };
    for (const Row& row : {Row{1.021, 3.0742, .0001, .1},
                           {1.040, 3.2010, .001, .05},
                           {1.08, 3.483, .01, .02},
                           {1.175, 4.065, .1, .02},
                           {1.15, 4.874, .4, .02}}) {
        const auto phase = [&](double s) { return f64::fournier_forand(row.index, row.slope, s); };
        EXPECT_NEAR(over_sphere(phase, 0.5, 1) / row.back, 1, row.tolerance) << row.index;
    }
}

TEST(WaterTypes, PureSeaWaterIsThatOfSmithAndBakerAt514Nanometres) {
    const WaterType& pure = water_types[0];
    EXPECT_NEAR(pure.absorption_per_m, .0357 + .4 * (.0477 - .0357), 5e-5);
    EXPECT_NEAR(pure.scattering_per_m, .0026 + .4 * (.0024 - .0026), 5e-5);
}

TEST(WaterTypes, ParticlesLieOnTheLineOfOceanicOnes) {
    for (const WaterType& water : water_types) {
        if (water.phase.type == Phase::Type::pure_water) continue;
        EXPECT_NEAR(water.phase.index, 1.01 + .1542 * (water.phase.slope - 3), 1e-4) << water.name;
    }
}

TEST(WaterTypes, TheTableOfAPhaseFunctionIsThatFunction) {
    for (const WaterType& water : water_types) {
        const PhaseTable table(water.phase);
        for (double angle = 0.01; angle < 3.14; angle *= 1.07) {
            const double sine2 = std::pow(std::sin(angle / 2), 2);
            const double exact = water.phase.type == Phase::Type::pure_water
                                     ? f64::pure_water(1 - 2 * sine2)
                                     : f64::fournier_forand(water.phase.index, water.phase.slope, sine2);
            const PhaseFraction read = table(static_cast<float>(1 - 2 * sine2));
            // In single precision the cosine of a small angle is no better.
            EXPECT_NEAR(read.numerator / read.denominator / exact, 1, 1e-3 + 1e-7 / sine2) << water.name << angle;
        }
    }
}

TEST(PhaseKernel, SinglePrecisionExponential) {
    for (float x = -86; x < 87; x += 0.37F) EXPECT_NEAR(f32::exp(x) / std::exp(double(x)), 1, 3e-7) << x;
    EXPECT_TRUE(std::isnan(f32::exp(std::nanf(""))));
    EXPECT_LT(f32::exp(-1e6F), 1e-37F);
}

}  // namespace
}  // namespace waterlight
