// What a hand does to the water, against sources of the scenario that are known before, against closed forms, and
// against what must not change: volume, and the waves that are there.
#include <gtest/gtest.h>

#include <numbers>

#include "sim/error.hpp"
#include "sim/prescribed.hpp"
#include "tests/support/airy_runs.hpp"
#include "tests/support/linear_runs.hpp"
#include "tests/support/shallow_runs.hpp"

namespace waterlight::testing {
namespace {

using Model = std::unique_ptr<WaveModel>;
using Make = std::function<Model(const std::vector<Source>&)>;

constexpr int nx = 96, ny = 80;
const Grid grid = make_grid(nx, ny, 2.4, 2.0);

Make airy_in(Boundary boundary) {
    return [boundary](const std::vector<Source>& sources) -> Model {
        AirySettings settings = tank(nx, ny, 2.4, 2.0, boundary, 0.5);
        settings.sines = {Sine{.amplitude_m = 0.004, .wavelength_m = 0.8}};
        if (boundary.x != Side::periodic) settings.sines.clear();
        settings.sources = sources;
        return make_airy(settings);
    };
}

Make linear_in(Boundary boundary) {
    return [boundary](const std::vector<Source>& sources) -> Model {
        LinearSettings settings = basin(nx, ny, 2.4, 2.0, boundary);
        settings.sources = sources;
        return make_linear<double>(settings);
    };
}

/// A beach that falls dry halfway.
ShallowWaterSettings beach(const std::vector<Source>& sources) {
    ShallowWaterSettings settings;
    settings.grid = grid;
    settings.bed_m = field_of(grid, [](int i, int) { return -0.2 + 0.15 * grid.x_m(i); });
    settings.sources = sources;
    return settings;
}

Make shallow = [](const std::vector<Source>& sources) -> Model { return make_shallow_water<double>(beach(sources)); };

struct Case {
    const char* name;
    Make make;
    bool is_linear;
};

std::ostream& operator<<(std::ostream& stream, const Case& c) { return stream << c.name; }

class Disturb : public ::testing::TestWithParam<Case> {};

const std::vector<Source> earlier{Drop{{1.4, 1.1}, 0.2, 0.01, 0}};
const Disturbance drop = Drop{{0.5, 0.9}, 0.15, -0.01, 0};
const Disturbance push = Push{{0.4, 1.3}, 0.2, 0.001};

double largest(const Field<float>& field) {
    double most = 0;
    for (const float value : field.values()) most = std::max(most, std::abs(static_cast<double>(value)));
    return most;
}

double sum(const Field<float>& field) {
    double total = 0;
    for (const float value : field.values()) total += value;
    return total;
}

void advance(WaveModel& model, int frames, double frame_s = 0.05) {
    for (int n = 0; n < frames; ++n) model.advance(frame_s);
}

TEST_P(Disturb, ADropByHandIsTheDropOfASourceAtThatTime) {
    const Model by_hand = GetParam().make(earlier);
    advance(*by_hand, 8);
    by_hand->disturb({&drop, 1});
    // The frames' own sum, to the last bit.
    std::vector<Source> sources = earlier;
    Drop known = std::get<Drop>(drop);
    for (int n = 0; n < 8; ++n) known.time_s += 0.05;
    sources.push_back(known);
    const Model by_source = GetParam().make(sources);
    advance(*by_source, 8);
    for (int n = 0; n < 6; ++n) {
        by_hand->advance(0.05);
        by_source->advance(0.05);
        const double difference = largest_difference(by_hand->surface().elevation, by_source->surface().elevation);
        EXPECT_LE(difference, 2e-7 * largest(by_source->surface().elevation)) << n;
    }
}

TEST_P(Disturb, KeepsTheVolume) {
    const Model model = GetParam().make(earlier);
    advance(*model, 5);
    const double before = sum(model->surface().elevation);
    for (const Disturbance& each : {drop, push, Disturbance(Push{{2.3, 0.2}, 0.3, -0.002})}) {
        model->disturb({&each, 1});
        EXPECT_NEAR(sum(model->surface().elevation), before, 2e-8 * nx * ny * largest(model->surface().elevation));
    }
}

TEST_P(Disturb, AddsToTheWavesThatAreThere) {
    if (!GetParam().is_linear) GTEST_SKIP() << "the model is not linear";
    const auto after = [&](const std::vector<Source>& sources, const std::vector<Disturbance>& disturbances) {
        const Model model = GetParam().make(sources);
        advance(*model, 4);
        model->disturb(disturbances);
        advance(*model, 7);
        return model->surface().elevation.clone();
    };
    const Field<float> both = after(earlier, {drop, push}), alone = after(earlier, {}), none = after({}, {}),
                       hand = after({}, {drop, push});
    const double size = largest(both);
    for (std::size_t n = 0; n < both.size(); ++n)
        ASSERT_NEAR(both.data()[n], alone.data()[n] + hand.data()[n] - none.data()[n], 1e-6 * size);
}

TEST_P(Disturb, GoesOnFromItsState) {
    const auto disturbed = [&] {
        Model model = GetParam().make(earlier);
        advance(*model, 3, 0.037);
        model->disturb(std::vector{drop, push});
        return model;
    };
    const Model whole = disturbed(), first = disturbed(), second = GetParam().make(earlier);
    StateArchive given;
    first->exchange_state(given);
    std::string bytes;
    for (const std::string& part : given.parts()) bytes += part;
    StateArchive taken(bytes);
    second->exchange_state(taken);
    taken.require_end();
    advance(*whole, 3, 0.037);
    advance(*second, 3, 0.037);
    EXPECT_EQ(largest_difference(whole->surface().elevation, second->surface().elevation), 0);
}

TEST_P(Disturb, RefusesNumbersThatAreNoneAndStaysAsItWas) {
    const Model model = GetParam().make(earlier);
    advance(*model, 3);
    const Field<float> before = model->surface().elevation.clone();
    const double nan = std::nan("");
    for (const Disturbance& wrong : {Disturbance(Drop{{nan, 1}, 0.1, 0.01, 0}), Disturbance(Drop{{1, 1}, 0, 0.01, 0}),
                                     Disturbance(Push{{1, 1}, -0.1, 0.01}), Disturbance(Push{{1, 1}, 0.1, nan})})
        EXPECT_THROW(model->disturb(std::vector{drop, wrong}), InputError);
    EXPECT_EQ(largest_difference(model->surface().elevation, before), 0);
}

TEST_P(Disturb, RainThatIsSetIsRainOfTheSettings) {
    const Rain rain{60, {0.08, 0.12}, {-0.01, -0.004}, 0, 1e30, 3}, other{20, {0.1, 0.1}, {0.01, 0.01}, 0, 1e30, 1};
    const Model known = GetParam().make({Source(rain)}), changed = GetParam().make({Source(other)}),
                none = GetParam().make({Source(rain)});
    changed->set_rain({&rain, 1});
    none->set_rain({});
    for (WaveModel* model : {known.get(), changed.get(), none.get()}) advance(*model, 10);
    EXPECT_GT(largest_difference(known->surface().elevation, none->surface().elevation), 1e-4);
    EXPECT_EQ(largest_difference(known->surface().elevation, changed->surface().elevation), 0);
}

INSTANTIATE_TEST_SUITE_P(Models, Disturb,
                         ::testing::Values(Case{"airy_walls", airy_in({Side::wall, Side::wall}), true},
                                           Case{"airy_periodic", airy_in({Side::periodic, Side::periodic}), true},
                                           Case{"linear_walls", linear_in({Side::wall, Side::wall}), true},
                                           Case{"linear_periodic", linear_in({Side::periodic, Side::wall}), true},
                                           Case{"shallow", shallow, false}),
                         [](const auto& test) { return test.param.name; });

TEST(DisturbAiry, AbsorbingSidesTakeDropsAsSourcesDo) {
    AirySettings settings = tank(nx, ny, 2.4, 2.0, {Side::absorbing, Side::absorbing}, 0.5);
    const auto by_hand = make_airy(settings);
    by_hand->advance(0.05);
    by_hand->disturb({&drop, 1});
    Drop known = std::get<Drop>(drop);
    known.time_s = 0.05;
    settings.sources = {known};
    const auto by_source = make_airy(settings);
    by_source->advance(0.05);
    by_hand->advance(0.3);
    by_source->advance(0.3);
    // Margins take the state through single precision step by step.
    EXPECT_LT(largest_difference(by_hand->surface().elevation, by_source->surface().elevation),
              1e-6 * largest(by_source->surface().elevation));
}

TEST(DisturbLinear, BetweenTwoStepsWaitsForTheNextAsASourceDoes) {
    const auto run = [](bool by_hand) {
        LinearSettings settings = basin(nx, ny, 2.4, 2.0, {Side::wall, Side::wall});
        Drop known = std::get<Drop>(drop);
        known.time_s = 0.05 + 0.0131;
        if (!by_hand) settings.sources = {known};
        auto model = make_linear<double>(settings);
        model->advance(0.05);
        model->advance(0.0131);
        EXPECT_GT(std::abs(std::remainder(0.0631, model->step_s())), 1e-4);
        if (by_hand) model->disturb({&drop, 1});
        model->advance(0.2);
        return model->surface().elevation.clone();
    };
    const Field<float> source = run(false);
    EXPECT_EQ(largest_difference(run(true), source), 0);
    EXPECT_GT(largest(source), 1e-3);
}

TEST(DisturbAiry, APushIsAGaussianLessTheMeanLevel) {
    const Push p{{1.1, 0.9}, 0.2, 0.002};
    const auto model = make_airy(tank(nx, ny, 2.4, 2.0, {Side::wall, Side::wall}, 0.5));
    const Disturbance d = p;
    model->disturb({&d, 1});
    const double height = p.volume_m3 / (pi * 0.04), level = p.volume_m3 / (2.4 * 2.0);
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) {
            const double q = (std::pow(grid.x_m(i) - 1.1, 2) + std::pow(grid.y_m(j) - 0.9, 2)) / 0.04;
            ASSERT_NEAR(model->surface().elevation(i, j), height * std::exp(-q) - level, 1e-6 * height);
        }
}

TEST(DisturbAiry, ModelsAgreeAtTheMomentOfAPush) {
    const Disturbance d = Push{{0.3, 0.2}, 0.2, 0.002};  // its images at two walls count
    const auto airy = make_airy(tank(nx, ny, 2.4, 2.0, {Side::wall, Side::wall}, 0.5));
    const auto linear = make_linear<double>(basin(nx, ny, 2.4, 2.0, {Side::wall, Side::wall}));
    ShallowWaterSettings flat;
    flat.grid = grid;
    const auto shallow_model = make_shallow_water<double>(flat);
    for (WaveModel* model : {static_cast<WaveModel*>(airy.get()), static_cast<WaveModel*>(linear.get()),
                             static_cast<WaveModel*>(shallow_model.get())})
        model->disturb({&d, 1});
    const double size = largest(airy->surface().elevation);
    EXPECT_LT(largest_difference(airy->surface().elevation, linear->surface().elevation), 2e-6 * size);
    EXPECT_LT(largest_difference(shallow_model->surface().elevation, linear->surface().elevation), 2e-6 * size);
}

TEST(DisturbShallow, FilmsKeepTheirDepthAboveZeroAndDryGroundIsLeftAlone) {
    const auto model = make_shallow_water<float>(beach({}));
    const double volume = model->totals().volume_m3;
    const int shore = static_cast<int>(0.2 / 0.15 / grid.dx_m);
    for (int n = 0; n < 40; ++n) {
        // Digs deeper than the water is, at the shore line.
        const std::array<Disturbance, 2> hard{Drop{{1.3, 1.0}, 0.2, -0.5, 0}, Push{{1.2, 0.5}, 0.2, -0.05}};
        model->disturb(hard);
        EXPECT_GE(shallowest_m(*model, grid), 0);
        if (n == 0) {
            for (int j = 0; j < ny; ++j) EXPECT_EQ(model->state(shore + 1, j).depth_m, 0);
        }
        model->advance(0.02);
        EXPECT_GE(shallowest_m(*model, grid), 0);
    }
    EXPECT_NEAR(model->totals().volume_m3, volume, 2e-6 * volume);
}

TEST(DisturbPrescribed, IsRefused) {
    PrescribedSettings settings;
    settings.grid = grid;
    settings.sines = {Sine{.amplitude_m = 0.01, .wavelength_m = 0.5}};
    const auto model = make_prescribed(settings);
    const Rain rain;
    for (const auto& act : {std::function<void()>([&] {
                                model->disturb({&drop, 1});
                            }),
                            std::function<void()>([&] {
                                model->set_rain({&rain, 1});
                            })}) {
        try {
            act();
            FAIL() << "accepted";
        } catch (const InputError& error) {
            EXPECT_STREQ(error.what(), "a prescribed surface cannot be disturbed");
        }
    }
}

TEST(Sphere, VolumeBelowStillWater) {
    const double whole = 4 * pi / 3 * std::pow(0.3, 3);
    EXPECT_EQ(submerged_volume_m3(0.3, 0.3), 0);
    EXPECT_EQ(submerged_volume_m3(5, 0.3), 0);
    EXPECT_NEAR(submerged_volume_m3(0, 0.3), whole / 2, 1e-15);
    EXPECT_NEAR(submerged_volume_m3(-0.3, 0.3), whole, 1e-15);
    EXPECT_NEAR(submerged_volume_m3(-2, 0.3), whole, 1e-15);
    // Its rate is the area of the section at still water.
    const double rate = (submerged_volume_m3(0.1 - 1e-6, 0.3) - submerged_volume_m3(0.1 + 1e-6, 0.3)) / 2e-6;
    EXPECT_NEAR(rate, pi * (0.09 - 0.01), 1e-8);
}

TEST(Sphere, PushesWaterAheadAndLeavesAHollowBehind) {
    const auto model = make_airy(tank(nx, ny, 2.4, 2.0, {Side::wall, Side::wall}, 0.5));
    std::vector<Disturbance> pushes;
    for (const Push& p : sphere_pushes({1.0, 1.0, -0.1}, {1.1, 1.0, -0.1}, 0.2)) pushes.emplace_back(p);
    model->disturb(pushes);
    const Surface& surface = model->surface();
    const auto elevation = [&](double x) { return surface.elevation(static_cast<int>(x / grid.dx_m), ny / 2); };
    EXPECT_GT(elevation(1.25), 0);
    EXPECT_LT(elevation(0.85), 0);
    EXPECT_NEAR(elevation(1.05 + 0.1125), -elevation(1.05 - 0.1125), 1e-7);
    // A sphere that stays where it is does nothing.
    const auto still = make_airy(tank(nx, ny, 2.4, 2.0, {Side::wall, Side::wall}, 0.5));
    pushes.clear();
    for (const Push& p : sphere_pushes({1.0, 1.0, -0.1}, {1.0, 1.0, -0.1}, 0.2)) pushes.emplace_back(p);
    still->disturb(pushes);
    EXPECT_LT(largest(still->surface().elevation), 1e-15 * largest(surface.elevation));
}

}  // namespace
}  // namespace waterlight::testing
