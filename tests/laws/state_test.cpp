// A model that takes the state of another goes on as that one does, bit by bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <functional>

#include "sim/airy.hpp"
#include "sim/error.hpp"
#include "sim/linear.hpp"
#include "sim/prescribed.hpp"
#include "sim/shallow_water_vulkan.hpp"
#include "tests/support/gpu_fixture.hpp"

namespace waterlight {
namespace {

using Make = std::function<std::unique_ptr<WaveModel>()>;

std::string joined(const StateArchive& archive) {
    std::string bytes;
    for (const std::string& part : archive.parts()) bytes += part;
    return bytes;
}

std::string state_of(WaveModel& model) {
    StateArchive archive;
    model.exchange_state(archive);
    EXPECT_EQ(joined(archive).size(), archive.bytes());
    return joined(archive);
}

void restore(WaveModel& model, std::string state) {
    StateArchive archive(std::move(state));
    model.exchange_state(archive);
    archive.require_end();
}

void expect_same(WaveModel& a, WaveModel& b, const std::string& when) {
    const Surface &s = a.surface(), &t = b.surface();
    EXPECT_EQ(s.time_s, t.time_s) << when;
    EXPECT_TRUE(std::ranges::equal(s.elevation.values(), t.elevation.values())) << when;
    EXPECT_TRUE(std::ranges::equal(s.slope_x.values(), t.slope_x.values())) << when;
    EXPECT_TRUE(std::ranges::equal(s.slope_y.values(), t.slope_y.values())) << when;
    EXPECT_EQ(a.steps(), b.steps()) << when;
    EXPECT_TRUE(state_of(a) == state_of(b)) << when;
}

/// At several times, whole steps and fractions of them: one model goes on, another takes its state, then both go on
/// alike; and asking for the state changes nothing.
void expect_to_go_on(const Make& make) {
    const auto plain = make(), watched = make();
    for (const double frame_s : {0.0, 0.1, 0.1, 0.037, 0.1}) {
        if (frame_s > 0) {
            plain->advance(frame_s);
            watched->advance(frame_s);
        }
        const auto restored = make();
        restored->surface();
        restore(*restored, state_of(*watched));
        expect_same(*restored, *watched, "at once");
        const auto ahead = make();
        restore(*ahead, state_of(*watched));
        for (const double more_s : {0.05, 0.2}) {
            restored->advance(more_s);
            ahead->advance(more_s);
            ahead->diagnostics();
            expect_same(*restored, *ahead, "later");
        }
    }
    expect_same(*plain, *watched, "asked and not asked");
}

const Grid grid = make_grid(24, 18, 3, 2);
const std::vector<Source> sources{Rain{40, {0.2, 0.4}, {-0.02, 0.01}, 0, 1e30, 4},
                                  Wavemaker{{0.3, 0}, {0.3, 2}, 0.01, 0.4, 0, 0, 1}, Drop{{1, 1}, 0.3, 0.02, 0.15}};

TEST(State, OfTheLinearModel) {
    for (const Boundary sides : {Boundary{Side::wall, Side::periodic}, Boundary{Side::absorbing, Side::wall}}) {
        LinearSettings s;
        s.grid = grid;
        s.boundary = sides;
        s.standing = {{}};
        s.sources = sources;
        expect_to_go_on([&] { return make_linear<float>(s); });
        expect_to_go_on([&] { return make_linear<double>(s); });
    }
}

TEST(State, OfTheAiryModel) {
    for (const Boundary sides : {Boundary{Side::wall, Side::periodic}, Boundary{Side::absorbing, Side::absorbing}}) {
        AirySettings s;
        s.grid = grid;
        s.boundary = sides;
        s.sources = sources;
        expect_to_go_on([&] { return make_airy(s); });
    }
}

TEST(State, OfThePrescribedModel) {
    PrescribedSettings s;
    s.grid = grid;
    s.boundary = {Side::periodic, Side::periodic};
    s.gerstner = GerstnerSettings{};
    expect_to_go_on([&] { return make_prescribed(s); });
}

/// A shore, friction, waves that come in, drops; with records.
ShallowWaterSettings shore() {
    ShallowWaterSettings s;
    s.grid = grid;
    s.bed_m = Field<double>(grid.nx, grid.ny);
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) s.bed_m(i, j) = -0.3 + 0.15 * grid.x_m(i);
    s.sides = {IncidentSide{{{0, 0.1, 0.3}, {0, 0.05, 0}}}, OpenSide{}, PeriodicSide{}, PeriodicSide{}};
    s.manning = 0.02;
    s.keep_records = true;
    s.sources = sources;
    return s;
}

void expect_same_records(const Make& make) {
    const auto first = make();
    first->advance(0.2);
    const auto second = make();
    restore(*second, state_of(*first));
    for (const auto& model : {&first, &second}) (*model)->advance(0.3);
    const auto records = [](WaveModel& model) { return dynamic_cast<ShallowWaterModel&>(model).records(); };
    for (const auto field :
         {&ShallowRecords::max_elevation_m, &ShallowRecords::max_speed_m_s, &ShallowRecords::arrival_s}) {
        const auto a = (records(*first)->*field).values(), b = (records(*second)->*field).values();
        EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size_bytes()), 0);
    }
}

TEST(State, OfShallowWater) {
    expect_to_go_on([] { return make_shallow_water<float>(shore()); });
    expect_to_go_on([] { return make_shallow_water<double>(shore()); });
    expect_same_records([] { return make_shallow_water<float>(shore()); });
}

using StateOnDevice = GpuTest;

TEST_F(StateOnDevice, OfShallowWater) {
    for (const bool staging : {false, true}) {
        open({.staging = staging, .validation = true});
        const Make make = [this] { return make_shallow_water_vulkan(shore(), context); };
        expect_to_go_on(make);
        expect_same_records(make);
    }
}

TEST(State, OfAnotherShapeIsRefused) {
    PrescribedSettings waves;
    waves.grid = grid;
    const auto prescribed = make_prescribed(waves);
    const std::string state = state_of(*prescribed);
    const auto shallow = make_shallow_water<float>(shore());
    EXPECT_THROW(restore(*shallow, state), WorldError);
    EXPECT_THROW(restore(*prescribed, state_of(*shallow)), WorldError);
    EXPECT_THROW(restore(*prescribed, state.substr(0, state.size() - 1)), WorldError);
    EXPECT_THROW(restore(*prescribed, ""), WorldError);
}

TEST(State, KeepsTextsAndListsOfAnyLength) {
    std::string text(100000, 'x'), empty;
    std::vector<double> list{1, 2, 3};
    StateArchive archive;
    archive.text(text);
    archive.text(empty);
    archive.list(list);
    StateArchive back(joined(archive));
    std::string text_back, empty_back = "not";
    std::vector<double> list_back;
    back.text(text_back);
    back.text(empty_back);
    back.list(list_back);
    EXPECT_EQ(text_back, text);
    EXPECT_EQ(empty_back, empty);
    EXPECT_EQ(list_back, list);
}

}  // namespace
}  // namespace waterlight
