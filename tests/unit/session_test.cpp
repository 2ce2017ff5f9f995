// The running scenario that a person plays with: what its commands do, and that it is the same each time.
#include "tests/unit/session_support.hpp"

#include <chrono>
#include <functional>
#include <thread>

#include "scenarios/resolve.hpp"
#include "sim/error.hpp"

namespace waterlight::test {
namespace {

TEST_F(SessionTest, BeginsWithTheFirstFrameAndStandsStill) {
    const Session session(scenario(), cpu, by_hand);
    const auto first = session.latest();
    EXPECT_EQ(first->number, 1U);
    EXPECT_EQ(first->time_s, 0);
    EXPECT_TRUE(first->has.floor);
    EXPECT_EQ(first->floor.irradiance.nx(), 40);
    EXPECT_FALSE(session.status().plays);
    EXPECT_EQ(session.status().rate, 0);
    const Scene scene = first->scene();
    EXPECT_EQ(scene.surface, &first->surface);
    EXPECT_EQ(scene.floor, &first->floor.irradiance);
    EXPECT_EQ(scene.ground_m, nullptr);
    EXPECT_EQ(scene.sun.elevation_deg, 70);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_EQ(session.latest()->number, 1U);
}

TEST_F(SessionTest, IsTheSameEachTimeItIsSteppedByHand) {
    const auto play = [&] {
        Session session(scenario(), cpu, by_hand);
        session.step();
        session.drop({0.7, 0.6}, 0.1, -0.01);
        session.step();
        session.hold_sphere({{1.4, 0.7, -0.1}, 0.2});
        session.move_sphere({1.3, 0.7, -0.05});
        session.step();
        session.sun(55, 20);
        return after(session, session.step());
    };
    const auto first = play(), second = play();
    EXPECT_NEAR(first->time_s, 4.0 / 30, 1e-12);
    EXPECT_TRUE(is_same(first->surface.elevation, second->surface.elevation));
    EXPECT_TRUE(is_same(first->floor.irradiance, second->floor.irradiance));
    EXPECT_GT(largest(first->surface.elevation), 1e-3);
}

TEST_F(SessionTest, ADropByHandIsThatOfTheSavedScenario) {
    Session session(scenario(), cpu, by_hand);
    session.step();
    session.drop({0.7, 0.6}, 0.1, -0.01);
    session.step();
    const auto shown = after(session, session.step());
    const fs::path file = folder_ / "elsewhere" / "saved.toml";
    session.save(file);
    Session again(read_scenario(file), cpu, by_hand);
    again.step();
    again.step();
    const auto repeated = after(again, again.step());
    const double size = largest(shown->surface.elevation);
    ASSERT_EQ(shown->time_s, repeated->time_s);
    for (std::size_t n = 0; n < shown->surface.elevation.size(); ++n)
        ASSERT_NEAR(shown->surface.elevation.data()[n], repeated->surface.elevation.data()[n], 2e-7 * size);
    EXPECT_NE(session.text().find("# A small pool."), std::string::npos);
}

TEST_F(SessionTest, SavesWhatWasSet) {
    Session session(scenario(), cpu, by_hand);
    session.sun(33.5, -20.25);
    session.set({"caustics.floor.footprint=pixel", "caustics.floor.pixels=[20, 15]"});
    session.rain(4.5);
    session.await(session.compute(LightPart::walls, true));
    ASSERT_EQ(session.status().refusal, "");
    session.save(folder_ / "saved.toml");
    const Scenario saved = read_scenario(folder_ / "saved.toml");
    const Scenario& shown = *session.latest()->scenario;
    EXPECT_EQ(saved.light.elevation_deg, 33.5);
    EXPECT_EQ(saved.light.azimuth_deg, -20.25);
    EXPECT_EQ(saved.floor->footprint, Footprint::pixel);
    EXPECT_EQ(saved.floor->pixels, glm::ivec2(20, 15));
    EXPECT_TRUE(saved.walls);
    ASSERT_EQ(saved.waves.sources.size(), 1U);
    const Rain rain = std::get<Rain>(saved.waves.sources[0]), there = std::get<Rain>(shown.waves.sources[0]);
    EXPECT_EQ(rain.drops_per_m2_s, 4.5);
    EXPECT_EQ(rain.radius_m, there.radius_m);
    session.await(session.rain(std::nullopt));
    session.save(folder_ / "saved.toml");
    EXPECT_LE(std::get<Rain>(read_scenario(folder_ / "saved.toml").waves.sources[0]).end_s, 1e-9);
    EXPECT_NE(session.text().find("# high"), std::string::npos);
    EXPECT_THROW(session.save("/proc/none/saved.toml"), WorldError);
}

TEST_F(SessionTest, KeepsTheWaterWhereLightAloneChanges) {
    Session session(scenario(), cpu, by_hand);
    session.drop({1, 0.7}, 0.1, 0.01);
    const auto before = after(session, session.step());
    for (const char* change :
         {"caustics.floor.footprint=pixel", "caustics.floor.pixels=[16, 12]", "caustics.floor.footprint",
          "caustics.floor.method=truth", "water.absorption_per_m=0.1", "waves.duration_s=3.0"}) {
        const auto now = after(session, session.set({change}));
        EXPECT_EQ(session.status().refusal, "") << change;
        EXPECT_EQ(session.status().note, "") << change;
        EXPECT_EQ(now->time_s, before->time_s) << change;
        EXPECT_TRUE(is_same(now->surface.elevation, before->surface.elevation)) << change;
    }
    EXPECT_EQ(session.latest()->floor.irradiance.nx(), 16);
    const auto dim = after(session, session.sun(20, 0));
    EXPECT_TRUE(is_same(dim->surface.elevation, before->surface.elevation));
    EXPECT_LT(dim->floor_ledger.floor_w, 0.5 * before->floor_ledger.floor_w);
}

TEST_F(SessionTest, BeginsAgainWhereTheWaterCannotGoOn) {
    Session session(scenario(), cpu, by_hand);
    session.drop({1, 0.7}, 0.1, 0.01);
    session.step();
    for (const char* change : {"waves.model=linear", "domain.cells=[60, 45]", "waves.model=shallow-water"}) {
        session.step();
        const auto now = after(session, session.set({change}));
        EXPECT_EQ(session.status().refusal, "") << change;
        EXPECT_NE(session.status().note, "") << change;
        EXPECT_EQ(now->time_s, 0) << change;
        EXPECT_EQ(largest(now->surface.elevation), 0) << change;
    }
    EXPECT_EQ(session.latest()->surface.elevation.nx(), 60);
    EXPECT_TRUE(session.latest()->ground_m);
}

TEST_F(SessionTest, WhatDoesNotGoLeavesWhatRuns) {
    Session session(scenario(), cpu, by_hand);
    session.drop({1, 0.7}, 0.1, 0.01);
    const auto before = after(session, session.step());
    const std::vector<std::function<Session::Ticket()>> wrong{
        [&] { return session.set({"waves.model=airies"}); },
        [&] { return session.set({"domain.cells=[0, 4]"}); },
        [&] {
            return session.set({"light.elevation_deg=30.0", "no.such.key=1"});
        },
        [&] {
            return session.set({"waves.file=nowhere.vti", "waves.model=prescribed"});
        },
        [&] {
            return session.set_device({Backend::cpu, "some device", false});
        },
        [&] { return session.speed(0); },
        [&] {
            return session.drop({std::nan(""), 0}, 0.1, 0.01);
        },
        [&] {
            return session.drop({1, 1}, 1e9, 0.01);
        },
        [&] {
            return session.move_sphere({1, 1, 0});
        },
        [&] { return session.sun(95, 0); },
        [&] { return session.rain(1e9); },
        [&] { return session.rain(-1); },
        [&] { return session.look(BeamView{.camera = {.fov_deg = 180}}); },
    };
    for (std::size_t n = 0; n < wrong.size(); ++n) {
        const Session::Ticket ticket = wrong[n]();
        session.await(ticket);
        const SessionStatus status = session.status();
        EXPECT_EQ(status.refused, ticket) << n;
        EXPECT_NE(status.refusal, "") << n;
        EXPECT_EQ(status.refusal.find('\n'), std::string::npos) << n;
        EXPECT_EQ(status.failure, "") << n;
    }
    const auto now = session.latest();
    EXPECT_TRUE(is_same(now->surface.elevation, before->surface.elevation));
    EXPECT_TRUE(is_same(now->floor.irradiance, before->floor.irradiance));
    EXPECT_EQ(now->scenario->light.elevation_deg, 70);
    EXPECT_GT(after(session, session.step())->time_s, before->time_s);
}

TEST_F(SessionTest, APrescribedSurfaceIsNotDisturbed) {
    const std::string frozen =
        "[domain]\nsize_m = [2.0, 2.0]\ncells = [16, 16]\ndepth_m = 1.0\n[waves]\nmodel = \"prescribed\"\n"
        "[[waves.sine]]\namplitude_m = 0.01\nwavelength_m = 1.0\n";
    Session session(scenario(frozen), cpu, by_hand);
    for (const auto ticket :
         {session.drop({1, 1}, 0.1, 0.01), session.rain(1.0), session.hold_sphere({{1, 1, 0}, 0.2})}) {
        session.await(ticket);
        EXPECT_EQ(session.status().refusal, "a prescribed surface cannot be disturbed");
    }
}

TEST_F(SessionTest, RainFallsWhileItIsOn) {
    Session session(scenario(), cpu, by_hand);
    session.speed(10);
    EXPECT_EQ(largest(after(session, session.step())->surface.elevation), 0);
    session.rain(30);
    const auto wet = after(session, session.step());
    EXPECT_GT(largest(wet->surface.elevation), 1e-4);
    session.rain(std::nullopt);
    session.reset();
    EXPECT_EQ(largest(after(session, session.step())->surface.elevation), 0);
    EXPECT_EQ(session.status().refusal, "");
}

TEST_F(SessionTest, ResetBeginsAgainAndForgetsDrops) {
    Session session(scenario(), cpu, by_hand);
    session.drop({1, 0.7}, 0.1, 0.01);
    session.step();
    const auto now = after(session, session.reset());
    EXPECT_EQ(now->time_s, 0);
    EXPECT_EQ(largest(now->surface.elevation), 0);
    EXPECT_EQ(session.text(), small_pool);
}

TEST_F(SessionTest, BeamsFollowTheCamera) {
    Session session(scenario(small_pool + "[caustics.beams]\ngrid = [24, 18]\n"), cpu, by_hand);
    EXPECT_FALSE(session.latest()->has.beams);
    BeamView view{{{0.2, 0.75, -0.4}, {1.8, 0.75, -0.4}, 60, {64, 48}}, 1, 2};
    const auto below = after(session, session.look(view));
    EXPECT_TRUE(below->has.beams);
    EXPECT_FALSE(below->has.volume);
    EXPECT_EQ(below->beams.radiance.nx(), 64);
    EXPECT_EQ(below->beams_camera.position_m.x, 0.2);
    view.camera.position_m.z = 2;
    const auto above = after(session, session.look(view));
    EXPECT_FALSE(above->has.beams);
    EXPECT_TRUE(above->has.volume);
    EXPECT_EQ(above->volume.cells, glm::ivec3(12, 9, 32));
    const auto none = after(session, session.compute(LightPart::beams, false));
    EXPECT_FALSE(none->has.volume);
    EXPECT_EQ(none->costs.beams_ms, 0);
    EXPECT_EQ(none->scene().volume, nullptr);
}

TEST_F(SessionTest, PartsAreAddedAndLeftOut) {
    Session session(scenario(), cpu, by_hand);
    EXPECT_FALSE(session.latest()->has.walls);
    const auto with = after(session, session.compute(LightPart::walls, true));
    EXPECT_TRUE(with->has.walls);
    EXPECT_GT(with->costs.walls_ms, 0);
    EXPECT_LT(with->walls_ledger.closure(), 1e-6);
    EXPECT_FALSE(after(session, session.compute(LightPart::walls, false))->has.walls);
    EXPECT_FALSE(after(session, session.compute(LightPart::floor, false))->has.floor);
    EXPECT_EQ(session.latest()->scene().floor, nullptr);
    // What the settings cannot have is refused and stays out.
    session.await(session.compute(LightPart::walls, false));
    session.await(session.set({"waves.boundary={x=\"periodic\", y=\"periodic\"}"}));
    EXPECT_NE(session.status().refusal, "");
}

TEST_F(SessionTest, EstimatesItsErrors) {
    Session session(scenario(small_pool, {"accuracy.estimate=true"}), cpu, by_hand);
    session.drop({1, 0.7}, 0.15, 0.01);
    const auto now = after(session, session.step());
    EXPECT_GT(now->estimates.floor_rmse, 0);
    EXPECT_LT(now->estimates.floor_rmse, 0.5);
    EXPECT_GE(now->estimates.waves_rmse, 0);
    EXPECT_LT(now->estimates.waves_rmse, 1e-3);
    EXPECT_EQ(now->estimates.time_s, now->time_s);
    EXPECT_TRUE(now->has.floor_error);
    EXPECT_TRUE(now->has.waves_error);
    EXPECT_GT(now->costs.estimate_ms, 0);
    EXPECT_EQ(now->scene().error, &now->floor_error);
    const auto off = after(session, session.set({"accuracy.estimate=false"}));
    EXPECT_EQ(off->time_s, now->time_s);
    EXPECT_FALSE(off->has.floor_error);
}

TEST_F(SessionTest, ColoursComeAsRedGreenBlue) {
    const Session session(scenario(small_pool, {"light.colour=rgb"}), cpu, by_hand);
    const auto now = session.latest();
    const Scene scene = now->scene();
    ASSERT_EQ(now->bands.size(), 3U);
    ASSERT_NE(scene.floor_rgb[0], nullptr);
    for (std::size_t n = 0; n < now->floor.irradiance.size(); ++n)
        ASSERT_NEAR(now->floor.irradiance.data()[n],
                    scene.floor_rgb[0]->data()[n] + scene.floor_rgb[1]->data()[n] + scene.floor_rgb[2]->data()[n],
                    0.01);
}

TEST_F(SessionTest, WavesThatBreakTheModelEndTheRunAndAResetBeginsAnother) {
    Session session(scenario(), cpu, by_hand);
    for (int n = 0; n < 3; ++n) session.drop({1, 0.7}, 0.1, 3e38);
    session.await(session.step());
    EXPECT_NE(session.status().failure, "");
    EXPECT_FALSE(session.status().plays);
    session.await(session.play());
    EXPECT_NE(session.status().refusal, "");
    EXPECT_TRUE(session.latest());
    const auto anew = after(session, session.reset());
    EXPECT_EQ(session.status().failure, "");
    EXPECT_EQ(largest(anew->surface.elevation), 0);
    EXPECT_GT(after(session, session.step())->time_s, 0);
}

TEST_F(SessionTest, WhatCannotBeBuiltIsThrown) {
    Scenario broken = scenario(small_pool + "[caustics.walls]\n");
    broken.walls->pixel_m = -1;
    EXPECT_THROW(Session(broken, cpu, by_hand), InputError);
    EXPECT_THROW(Session(scenario(), cpu, {.frame_s = 0}), InputError);
}

}  // namespace
}  // namespace waterlight::test
