// What comes back from an absorbing side.
#include <gtest/gtest.h>

#include "sim/airy_dispersion.hpp"
#include "sim/airy_margin.hpp"
#include "tests/support/airy_runs.hpp"

namespace waterlight::testing {
namespace {

constexpr double tank_m = 16;
constexpr int cells = 256;

/// Waves towards +x over shallow or deep water, filling the domain at the start.
struct Leaving {
    double wavelength_m, depth_m;

    Water water() const {
        Water water;
        water.depth_m = depth_m;
        return water;
    }
    AbsorbingMargin margin() const { return make_margin(Side::absorbing, cells, tank_m / cells, 0, water()); }
    double wave_number() const { return 2 * pi / wavelength_m; }
    double transmitted() const { return transmitted_fraction(margin(), wave_number(), water()); }

    /// rms of the elevation after the wave has run once through domain and margins, over its first value.
    double remainder() const {
        AirySettings settings = tank(cells, 4, tank_m, 0.25, {Side::absorbing, Side::periodic}, depth_m);
        settings.sines = {{0.01, wavelength_m, 0, 0, false}};
        const auto model = make_airy(settings);
        const double before = rms_of(model->surface().elevation);
        model->advance((tank_m + 2 * margin().width_m) / airy_group_velocity(wave_number(), water()));
        return rms_of(model->surface().elevation) / before;
    }
};

/// Share of the amplitude that comes back from the far side of the domain when a wavemaker sends steady waves, by least
/// squares of elevation = a exp(ikx - iwt) + b exp(-ikx - iwt).
double reflected_fraction(double wavelength, double depth, bool along_x, Side other) {
    AirySettings settings = along_x ? tank(cells, 4, tank_m, 0.25, {Side::absorbing, other}, depth)
                                    : tank(4, cells, 0.25, tank_m, {other, Side::absorbing}, depth);
    const double k = 2 * pi / wavelength, period = 2 * pi / airy_omega(k, settings.water);
    const glm::dvec2 from = along_x ? glm::dvec2{4, 0} : glm::dvec2{0, 4},
                     to = along_x ? glm::dvec2{4, 0.25} : glm::dvec2{0.25, 4};
    settings.sources = {Wavemaker{from, to, 0.01, period, 0, 0, 10}};
    const auto model = make_airy(settings);
    model->advance(72 / airy_group_velocity(k, settings.water) + 20 * period);
    std::vector<std::complex<double>> harmonic(cells);
    for (int n = 0; n < 16; ++n) {
        for (int i = 0; i < cells; ++i)
            harmonic[i] +=
                std::polar(1.0, 2 * pi * n / 16) *
                static_cast<double>(along_x ? model->surface().elevation(i, 1) : model->surface().elevation(1, i));
        model->advance(period / 16);
    }
    std::complex<double> a = 0, b = 0, overlap = 0;
    double count = 0;
    for (int i = 160; i < cells; ++i, ++count) {
        const auto onward = std::polar(1.0, k * (i + 0.5) * tank_m / cells);
        a += std::conj(onward) * harmonic[i];
        b += onward * harmonic[i];
        overlap += std::conj(onward) * std::conj(onward);
    }
    return std::abs((count * b - std::conj(overlap) * a) / (count * a - overlap * b));
}

TEST(Airy, AbsorbingSidesReflectLittle) {
    const struct { double wavelength_m, limit; } bounds[] = {{0.5, 1e-4}, {1, 1e-4}, {2, 6e-4}, {4, 0.015}, {8, 0.11}};
    for (const double depth : {0.3, 2.0, 100.0}) {
        for (const auto& bound : bounds) {
            const double passes = Leaving{bound.wavelength_m, depth}.transmitted();
            for (const bool along_x : {true, false})
                for (const Side other : {Side::periodic, Side::wall})
                    EXPECT_LT(reflected_fraction(bound.wavelength_m, depth, along_x, other), bound.limit + passes)
                        << bound.wavelength_m << " m over " << depth << " m";
        }
    }
}

TEST(Airy, MarginsTransmitWhatTheirDampingSays) {
    // Long waves over shallow water keep their shape, so that after one turn all of what passed is back in its place.
    for (const double wavelength : {0.4, 0.6, 1.0}) {
        const Leaving leaving{wavelength, 0.01};
        EXPECT_NEAR(leaving.remainder(), leaving.transmitted(), 0.05 * leaving.transmitted()) << wavelength << " m";
    }
}

/// Largest difference of a drop in a tank with absorbing sides from the same in one so large that nothing comes back,
/// over the drop's height.
double difference_from_open_water(double radius, glm::dvec2 at, double until_s) {
    AirySettings settings = tank(96, 96, 6, 6, {Side::absorbing, Side::absorbing}, 0.5);
    settings.sources = {Drop{at, radius, 0.01, 0}};
    AirySettings wide = settings;
    wide.grid = {576, 576, settings.grid.dx_m, settings.grid.dy_m, -15, -15};
    wide.boundary = {};
    const auto model = make_airy(settings), open = make_airy(wide);
    double largest = 0;
    for (double t = 0; t < until_s; t += 0.25) {
        model->advance(0.25);
        open->advance(0.25);
        largest = std::max(largest, largest_error(model->surface().elevation, settings.grid, [&](double x, double y) {
                               return open->surface().elevation(static_cast<int>((x + 15) / settings.grid.dx_m),
                                                                static_cast<int>((y + 15) / settings.grid.dy_m));
                           }));
    }
    return largest / 0.01;
}

TEST(Airy, DropInAnAbsorbingTankIsADropInOpenWater) {
    EXPECT_LT(difference_from_open_water(0.2, {3, 3}, 6), 0.003);
    EXPECT_LT(difference_from_open_water(0.2, {4.5, 3}, 6), 0.003);
    EXPECT_LT(difference_from_open_water(0.5, {3, 3}, 6), 0.02);
}

}  // namespace
}  // namespace waterlight::testing
