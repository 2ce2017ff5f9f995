// Pictures of a run's scene, and the movie of them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/scenarios/program.hpp"
#include "tests/support/child.hpp"

namespace waterlight::test {
namespace {

namespace fs = std::filesystem;

const std::string small =
    "[domain]\nsize_m = [2.0, 1.5]\ncells = [32, 24]\ndepth_m = 0.5\n"
    "[waves]\nmodel = \"airy\"\nduration_s = 0.35\n[[waves.standing]]\namplitude_m = 0.01\nhalf_waves_x = 4\n"
    "[light]\nelevation_deg = 60.0\nazimuth_deg = 30.0\n[caustics.floor]\npixels = [64, 48]\n"
    "[camera]\nposition_m = [1.0, -0.6, 1.4]\ntarget_m = [1.0, 0.75, -0.2]\npixels = [81, 45]\n"
    "[output]\nformats = [\"png\"]\nimage = true\nevery_s = 0.1\n";

class Pictures : public ::testing::Test {
  protected:
    Outcome run(const std::vector<std::string>& more = {}, const std::string& environment = "") const {
        std::vector<std::string> arguments{"run", scenario_.string(), "--out", out_.string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_program(arguments, environment);
    }
    std::string picture(int frame) const { return read_file(out_ / fmt::format("images/scene_{:06}.png", frame)); }
    nlohmann::json report() const { return nlohmann::json::parse(read_file(out_ / "report.json")); }

    Scratch folder_{testing::UnitTest::GetInstance()->current_test_info()->name()};
    fs::path scenario_ = folder_.write("small.toml", small);
    fs::path out_ = folder_ / "out";
};

/// Width and height that a .png states.
std::pair<int, int> size_of(const std::string& png) {
    const auto number = [&](std::size_t at) {
        int value = 0;
        for (std::size_t i = 0; i < 4; ++i) value = 256 * value + static_cast<unsigned char>(png.at(at + i));
        return value;
    };
    return {number(16), number(20)};
}

/// What ffprobe says of the movie's frames, one value a line.
std::string probed(const fs::path& movie, const std::string& entries) {
    const std::string command = "ffprobe -v error -count_frames -select_streams v:0 -show_entries stream=" + entries +
                                " -of default=nokey=1:noprint_wrappers=1 " + quoted(movie.string()) + " 2>&1";
    std::string text;
    std::FILE* pipe = popen(command.c_str(), "r");
    for (int c = 0; (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
    pclose(pipe);
    return text;
}

bool has_ffmpeg() { return std::system("command -v ffmpeg ffprobe >/dev/null 2>&1") == 0; }

TEST_F(Pictures, AreOneAFrameOfTheSizeAsked) {
    const Outcome outcome = run({"--validate", "--backend", "cpu"});
    ASSERT_EQ(outcome.exit, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("scene_*.png"), std::string::npos) << outcome.output;
    for (int frame = 0; frame < 5; ++frame) EXPECT_EQ(size_of(picture(frame)), std::pair(81, 45));
    EXPECT_FALSE(fs::exists(out_ / "images/scene_000005.png"));
    EXPECT_NE(picture(0), picture(4)) << "the water moves";
    EXPECT_GT(report()["wall_s"]["render"].get<double>(), 0);
    EXPECT_FALSE(report()["render"]["device"].get<std::string>().empty());
}

TEST_F(Pictures, OfATruthAreDrawnByADeviceThatTheMapDoesNotUse) {
    const Outcome outcome = run({"--validate", "--set", "caustics.floor={method=\"truth\", pixels=[16, 12]}"});
    ASSERT_EQ(outcome.exit, 0) << outcome.output;
    EXPECT_EQ(report()["backend"]["name"], "cpu");
    EXPECT_EQ(size_of(picture(4)), std::pair(81, 45));
    EXPECT_EQ(run({"--validate", "--set", "output.image=false", "--set", "caustics.floor.method=\"truth\""}).exit, 2);
}

TEST_F(Pictures, AreExplained) {
    const Outcome outcome = run_program({"explain", scenario_.string()});
    EXPECT_NE(outcome.output.find("81 x 45 pixels of 4 samples"), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("for pictures"), std::string::npos) << outcome.output;
    const Outcome without = run_program({"explain", scenario_.string(), "--set", "output.image=false"});
    EXPECT_EQ(without.output.find("pictures"), std::string::npos) << without.output;
}

TEST_F(Pictures, WithoutImageNothingIsDrawnAndNoDeviceOpened) {
    const Outcome outcome =
        run({"--set", "output.image=false"}, "VK_DRIVER_FILES=/nonexistent VK_ICD_FILENAMES=/nonexistent");
    ASSERT_EQ(outcome.exit, 0) << outcome.output;
    EXPECT_FALSE(fs::exists(out_ / "images/scene_000000.png"));
    EXPECT_EQ(report()["wall_s"]["render"], 0);
    EXPECT_FALSE(report().contains("render"));
}

TEST_F(Pictures, WithoutADeviceTheRunSaysWhatToInstall) {
    const Outcome outcome = run({}, "VK_DRIVER_FILES=/nonexistent VK_ICD_FILENAMES=/nonexistent");
    EXPECT_EQ(outcome.exit, 3);
    EXPECT_NE(outcome.output.find("output.image: pictures of the scene are drawn by Vulkan"), std::string::npos)
        << outcome.output;
    EXPECT_NE(outcome.output.find("mesa-vulkan-drivers"), std::string::npos) << outcome.output;
    EXPECT_FALSE(fs::exists(out_)) << "before anything is written";
}

/// The same moment looks the same in a run of other frames: the picture has no memory.
TEST_F(Pictures, DependOnTheirFrameAlone) {
    ASSERT_EQ(run().exit, 0);
    const std::string third = picture(2);
    ASSERT_EQ(run({"--set", "output.every_s=0.2"}).exit, 0);
    EXPECT_EQ(picture(1), third);
    EXPECT_FALSE(fs::exists(out_ / "images/scene_000003.png")) << "left by the longer run";
}

TEST_F(Pictures, ACameraInTheGroundIsRefused) {
    const std::string ground =
        "domain.ground=[{type=\"bump\", at_m=[1.0, 0.7], half_width_m=[0.5, 0.5], height_m=0.9}]";
    const std::vector<std::string> more{"--set", ground,        "--set", "waves.model=\"shallow-water\"",
                                        "--set", "caustics={}", "--set"};
    std::vector<std::string> inside = more, above = more;
    inside.emplace_back("camera.position_m=[1.0, 0.7, 0.3]");
    above.emplace_back("camera.position_m=[1.0, 0.7, 0.5]");
    const Outcome refused = run(inside);
    EXPECT_EQ(refused.exit, 2);
    EXPECT_NE(refused.output.find("camera.position_m: found a height of 0.3 m; allowed: above the ground there"),
              std::string::npos)
        << refused.output;
    EXPECT_EQ(run(above).exit, 0);
}

TEST_F(Pictures, AnOverlayHasALegendAroundIt) {
    ASSERT_EQ(run({"--set", "picture.overlay=irradiance"}).exit, 0);
    const auto [width, height] = size_of(picture(0));
    EXPECT_GT(width, 81 + 14);
    EXPECT_GT(height, 45 + 14);
}

TEST_F(Pictures, TheMovieHasEveryFrameThatIsOnTheBeat) {
    if (!has_ffmpeg()) GTEST_SKIP() << "needs ffmpeg and ffprobe";
    const Outcome outcome = run({"--movie"});
    ASSERT_EQ(outcome.exit, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("movie.mp4"), std::string::npos) << outcome.output;
    // Of 0, 0.1, 0.2, 0.3 s; the frame at the end, 0.35 s, is off it. Sides are made even.
    EXPECT_EQ(probed(out_ / "movie.mp4", "codec_name,width,height,pix_fmt,r_frame_rate,nb_read_frames"),
              "h264\n82\n46\nyuv420p\n10/1\n4\n");
    for (const fs::directory_entry& entry : fs::directory_iterator(out_))
        EXPECT_FALSE(entry.path().filename().string().ends_with(".part")) << entry.path();
}

TEST_F(Pictures, AMovieOfARunThatWasInterruptedHasAllFrames) {
    if (!has_ffmpeg()) GTEST_SKIP() << "needs ffmpeg and ffprobe";
    const std::vector<std::string> arguments{"run",     scenario_.string(), "--out", out_.string(),
                                             "--movie", "--resume",         "--set", "waves.duration_s=3"};
    {
        Child child(arguments, folder_ / "log");
        ASSERT_TRUE(wait_until([&] { return fs::exists(out_ / "images/scene_000002.png"); }));
        child.kill(SIGINT);
        ASSERT_EQ(child.wait(), 128 + SIGINT) << child.output();
        EXPECT_FALSE(fs::exists(out_ / "movie.mp4"));
    }
    const Outcome outcome = run_program(arguments);
    ASSERT_EQ(outcome.exit, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("going on from"), std::string::npos) << outcome.output;
    EXPECT_EQ(probed(out_ / "movie.mp4", "nb_read_frames"), "31\n");
}

TEST_F(Pictures, TheMovieGoesWhereAndAsFastAsAsked) {
    if (!has_ffmpeg()) GTEST_SKIP() << "needs ffmpeg and ffprobe";
    const fs::path file = folder_ / "a slow.mp4";
    ASSERT_EQ(run({"--movie=" + file.string(), "--movie-speed", "0.5"}).exit, 0);
    EXPECT_EQ(probed(file, "r_frame_rate,nb_read_frames"), "5/1\n4\n");
    EXPECT_FALSE(fs::exists(out_ / "movie.mp4"));
}

TEST_F(Pictures, AMovieThatCannotBeIsRefusedBeforeTheRun) {
    const Outcome none = run({"--movie", "--set", "output.image=false"});
    EXPECT_EQ(none.exit, 2);
    EXPECT_NE(none.output.find("output.image: found false beside --movie"), std::string::npos) << none.output;
    const Outcome missing = run({"--movie"}, "PATH=/nonexistent");
    EXPECT_EQ(missing.exit, 3);
    EXPECT_NE(missing.output.find("Debian's package is ffmpeg"), std::string::npos) << missing.output;
    EXPECT_EQ(run({"--movie-speed", "2"}).exit, 2);
    EXPECT_FALSE(fs::exists(out_));
}

/// A program in ffmpeg's place that fails, or that reads nothing.
TEST_F(Pictures, AMovieThatFailsLeavesNoFileAndSaysWhy) {
    const fs::path stand_in = folder_.write("ffmpeg",
                                            "#!/bin/sh\nfor file; do :; done\necho part > \"${file#file:}\"\n"
                                            "echo 'no such codec'\nexit 1\n");
    fs::permissions(stand_in, fs::perms::owner_all);
    const Outcome outcome = run({"--movie"}, "PATH=" + quoted(stand_in.parent_path().string()) + ":$PATH");
    EXPECT_EQ(outcome.exit, 3);
    EXPECT_NE(outcome.output.find("movie.mp4: ffmpeg: no such codec"), std::string::npos) << outcome.output;
    EXPECT_FALSE(fs::exists(out_ / "movie.mp4"));
    EXPECT_FALSE(fs::exists(out_ / ".movie.mp4.part"));
    EXPECT_EQ(size_of(picture(0)), std::pair(81, 45)) << "the pictures are there";
}

}  // namespace
}  // namespace waterlight::test
