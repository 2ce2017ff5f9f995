// When the world fails the run says why in one line, exits 3, and leaves whole files only.
#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/stat.h>

#include <algorithm>
#include <string>

#include "sim/vti_reader.hpp"
#include "tests/support/child.hpp"
#include "tests/support/run_files.hpp"

namespace waterlight::test {
namespace {

namespace fs = std::filesystem;

/// Runs for minutes, with a frame every few milliseconds.
const std::string long_run =
    "[domain]\nsize_m = [1.0, 1.0]\ncells = [48, 48]\ndepth_m = 0.5\n"
    "[waves]\nmodel = \"airy\"\nduration_s = 500\n[[waves.standing]]\namplitude_m = 0.01\nhalf_waves_x = 4\n"
    "[caustics.floor]\npixels = [48, 40]\n[output]\nevery_s = 0.05\ncheckpoint_every_s = 0.02\n"
    "formats = [\"vti\", \"png\", \"exr\"]\n[[probe]]\nname = \"corner\"\nat_m = [0.0, 0.0]\n";

void expect_one_line(const std::string& output, const std::vector<std::string>& parts) {
    EXPECT_EQ(std::count(output.begin(), output.end(), '\n'), 1) << output;
    for (const std::string& part : parts) EXPECT_NE(output.find(part), std::string::npos) << output;
}

/// Nothing is in the making, series name whole frames, tables end in whole rows, pictures have their end.
/// Where nothing may be removed, what was in the making stays, under its hidden name, until the next run.
void expect_whole_files(const fs::path& folder, bool may_remove = true) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        const fs::path& path = entry.path();
        const std::string kind = path.extension(), text = entry.is_regular_file() ? read_file(path) : "";
        EXPECT_FALSE(may_remove && kind == ".part") << path;
        if (kind == ".vti") {
            const bool is_floor = path.stem().string().starts_with("floor");
            EXPECT_NO_THROW(read_vti(path, is_floor ? "irradiance" : "elevation")) << path;
        } else if (kind == ".csv") {
            EXPECT_EQ(text.back(), '\n') << path;
        } else if (kind == ".png") {
            EXPECT_EQ(text.substr(text.size() - 8, 4), "IEND") << path;
        } else if (kind == ".pvd") {
            for (const TimedFile& frame : read_pvd(path)) EXPECT_TRUE(fs::exists(frame.path)) << frame.path;
        }
    }
}

class Faults : public ::testing::Test {
  protected:
    Faults() { fs::permissions(folder_ / ".", fs::perms::all); }

    std::vector<std::string> arguments(const fs::path& out, std::vector<std::string> more = {}) const {
        more.insert(more.begin(), {"run", scenario_.string(), "--quiet", "--out", out.string()});
        return more;
    }
    Child start(const ChildLimits& limits = {}) const { return Child(arguments(out_), folder_ / "log", limits); }
    bool wait_for_frames() const {
        return wait_until([&] { return fs::exists(out_ / "checkpoint.bin"); });
    }
    void expect_exit_three(Child& child, const std::vector<std::string>& parts) const {
        EXPECT_EQ(child.wait(), 3) << child.output();
        expect_one_line(child.output(), parts);
    }

    Scratch folder_{"faults", quick_place()};
    fs::path scenario_ = folder_.write("long.toml", long_run);
    fs::path out_ = folder_ / "out";
};

TEST_F(Faults, ASecondRunIntoTheSameFolderIsRefused) {
    Child first = start();
    ASSERT_TRUE(wait_for_frames());
    const Outcome second = run_program(arguments(out_));
    EXPECT_EQ(second.exit, 3);
    expect_one_line(second.output, {"another run (process " + std::to_string(first.process()) + ") writes into it"});
    first.kill(SIGINT);
    EXPECT_EQ(first.wait(), 130) << "the first is not disturbed: " << first.output();
    expect_whole_files(out_);
    EXPECT_EQ(run_program(arguments(out_, {"--resume", "--set", "waves.duration_s=1"})).exit, 2)
        << "the folder is free again, for the same run";
}

TEST_F(Faults, TheLockOfARunThatWasKilledHoldsNothing) {
    Child first = start();
    ASSERT_TRUE(wait_for_frames());
    first.kill(SIGKILL);
    first.wait();
    EXPECT_EQ(run_program(arguments(out_, {"--set", "waves.duration_s=0.2"})).exit, 0);
    EXPECT_FALSE(fs::exists(out_ / ".waterlight.lock"));
}

TEST_F(Faults, WhatWasInTheMakingIsRemovedByTheNextRunAndNothingElse) {
    fs::create_directories(out_ / "surface");
    std::ofstream(out_ / "surface" / ".surface_000003.vti.part") << "x";
    std::ofstream(out_ / ".checkpoint.bin.part") << "x";
    std::ofstream(out_ / ".mine.part") << "x";
    EXPECT_EQ(run_program(arguments(out_, {"--set", "waves.duration_s=0.2"})).exit, 0);
    EXPECT_FALSE(fs::exists(out_ / "surface" / ".surface_000003.vti.part"));
    EXPECT_FALSE(fs::exists(out_ / ".checkpoint.bin.part"));
    EXPECT_TRUE(fs::exists(out_ / ".mine.part"));
}

TEST_F(Faults, AFolderThatVanishesStopsTheRun) {
    Child child = start();
    ASSERT_TRUE(wait_for_frames());
    fs::rename(out_, folder_ / "elsewhere");
    expect_exit_three(child, {"the folder " + out_.string() + " vanished while the run wrote into it"});
    // At most the file at hand is begun anew.
    const auto files = fs::exists(out_) ? fs::recursive_directory_iterator(out_) : fs::recursive_directory_iterator();
    EXPECT_LE(std::count_if(begin(files), end(files), [](const auto& entry) { return entry.is_regular_file(); }), 1);
    expect_whole_files(folder_ / "elsewhere", false);
}

TEST_F(Faults, AFrameThatVanishesIsMissedAtTheEnd) {
    Child child = start();
    ASSERT_TRUE(wait_for_frames());
    fs::remove(out_ / "surface" / "surface_000000.vti");
    child.kill(SIGINT);
    expect_exit_three(child, {"surface_000000.vti was written by this run and is gone"});
}

TEST_F(Faults, AFolderThatBecomesReadOnlyStopsTheRun) {
    ChildLimits limits;
    limits.obeys_permissions = true;
    Child child = start(limits);
    ASSERT_TRUE(wait_for_frames());
    const auto readable = static_cast<fs::perms>(0555);
    for (const fs::path& folder : {out_, out_ / "surface", out_ / "floor", out_ / "images"})
        fs::permissions(folder, readable);
    EXPECT_EQ(child.wait(), 3) << child.output();
    expect_one_line(child.output(), {"cannot write", "Permission denied", "the last good checkpoint is"});
    expect_whole_files(out_, false);
    for (const fs::path& folder : {out_, out_ / "surface", out_ / "floor", out_ / "images"})
        fs::permissions(folder, fs::perms::all);
}

/// A small disk of its own; only root may have one.
class SmallDisk {
  public:
    explicit SmallDisk(fs::path path) : path_(std::move(path)) {
        fs::create_directory(path_);
        mounted_ = ::mount("none", path_.c_str(), "tmpfs", 0, "size=2m") == 0;
    }
    ~SmallDisk() {
        if (mounted_) ::umount2(path_.c_str(), MNT_DETACH);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;
    bool mounted() const { return mounted_; }
    void grow() const { ASSERT_EQ(::mount("none", path_.c_str(), "tmpfs", MS_REMOUNT, "size=100m"), 0); }

  private:
    fs::path path_;
    bool mounted_ = false;
};

TEST_F(Faults, AFullDiskStopsTheRunWhichGoesOnWhereThereIsRoom) {
    const SmallDisk disk(folder_ / "disk");
    if (!disk.mounted()) GTEST_SKIP() << "only root may mount a small disk";
    const std::vector<std::string> shorter{"--set", "waves.duration_s=4"};
    ASSERT_EQ(run_program(arguments(out_, shorter)).exit, 0);
    const fs::path out = folder_ / "disk" / "out";
    const Outcome full = run_program(arguments(out, shorter));
    EXPECT_EQ(full.exit, 3);
    expect_one_line(full.output, {"cannot write", "the last good checkpoint is"});
    expect_whole_files(out);
    disk.grow();
    std::vector<std::string> again = shorter;
    again.emplace_back("--resume");
    EXPECT_EQ(run_program(arguments(out, again)).exit, 0);
    EXPECT_EQ(differences(files_of(out_), files_of(out)), "");
}

TEST_F(Faults, AFileThatMayNotGrowStopsTheRun) {
    // Under the size of a frame of 48 x 48 cells, above that of others.
    for (const rlim_t most : {20000, 3000}) {
        fs::remove_all(out_);
        ChildLimits limits;
        limits.file_bytes = most;
        Child child = start(limits);
        EXPECT_EQ(child.wait(), 3) << child.output();
        expect_one_line(child.output(), {"cannot write"});
        expect_whole_files(out_);
    }
}

TEST_F(Faults, WhatCannotBePrintedIsNotTakenForDone) {
    Child child({"schema"}, "/dev/full");
    EXPECT_EQ(child.wait(), 3);
}

TEST_F(Faults, MemoryThatWillNotDoIsForetoldWithTheFigure) {
    const Outcome huge = run_program(arguments(out_, {"--set", "domain.cells=[60000,60000]"}));
    EXPECT_EQ(huge.exit, 2);
    expect_one_line(huge.output, {"domain.cells", "GiB", "memory that this machine has free"});
    ChildLimits limits;
    limits.address_bytes = rlim_t{2} << 30;
    Child child(arguments(out_, {"--set", "domain.cells=[6000,6000]"}), folder_ / "log", limits);
    EXPECT_EQ(child.wait(), 2) << child.output();
    expect_one_line(child.output(), {"domain.cells", "GiB"});
    EXPECT_FALSE(fs::exists(out_)) << "before anything is written";
}

TEST_F(Faults, NoVulkanDeviceIsSaidWithItsReason) {
    ChildLimits limits;
    limits.environment = {"VK_ICD_FILENAMES=/nonexistent", "VK_DRIVER_FILES=/nonexistent"};
    Child child(arguments(out_, {"--backend", "vulkan"}), folder_ / "log", limits);
    EXPECT_EQ(child.wait(), 3);
    expect_one_line(child.output(), {"Vulkan", "driver"});
}

TEST_F(Faults, ADeviceThatIsLostStopsTheRunWhichGoesOnLater) {
    const std::vector<std::string> shorter{"--backend", "vulkan", "--set", "waves.duration_s=1"};
    ASSERT_EQ(run_program(arguments(folder_ / "plain", shorter)).exit, 0);
    ChildLimits limits;
    limits.environment = {"VK_LAYER_PATH=" WATERLIGHT_LAYERS, "VK_INSTANCE_LAYERS=VK_LAYER_WATERLIGHT_lost_device",
                          "WATERLIGHT_LOST_AFTER=15"};
    Child child(arguments(out_, shorter), folder_ / "log", limits);
    expect_exit_three(child, {"the Vulkan device was lost", "checkpoint"});
    expect_whole_files(out_);
    std::vector<std::string> again = shorter;
    again.emplace_back("--resume");
    EXPECT_EQ(run_program(arguments(out_, again)).exit, 0);
    EXPECT_EQ(differences(files_of(folder_ / "plain"), files_of(out_)), "");
}

TEST_F(Faults, WhatIsNotFiniteIsNamedWithItsPlaceAndTheLastCheckpoint) {
    // A drop beyond single precision falls in the middle of the run.
    const fs::path scenario = folder_.write(
        "infinite.toml",
        "[domain]\nsize_m = [1.0, 1.0]\ncells = [16, 16]\ndepth_m = 0.5\n[waves]\nmodel = \"linear\"\nduration_s = "
        "0.5\n"
        "[output]\ncheckpoint_every_s = 1e-6\n"
        "[[waves.source]]\ntype = \"drop\"\nat_m = [0.5, 0.5]\nradius_m = 0.15\nheight_m = 1e39\ntime_s = 0.25\n");
    for (const std::string model : {"linear", "airy"}) {
        const Outcome outcome = run_program(
            {"run", scenario.string(), "--quiet", "--out", out_.string(), "--set", "waves.model=\"" + model + "\""});
        EXPECT_EQ(outcome.exit, 3);
        // The first line warns of waves that break.
        expect_one_line(outcome.output.substr(outcome.output.find('\n') + 1),
                        {"the elevation is not finite", "in cell (", "at t = 0.3 s, step ",
                         "the last good checkpoint is " + (out_ / "checkpoint.bin").string(), "of t = 0.2 s"});
        expect_whole_files(out_);
    }
}

/// A run whose surface comes from the frames of another, read one after the other.
class SeriesFaults : public Faults {
  protected:
    void SetUp() override {
        const std::vector<std::string> few{"--set", "waves.duration_s=20", "--set", "output.formats=[\"vti\"]"};
        ASSERT_EQ(run_program(arguments(folder_ / "source", few)).exit, 0);
        scenario_ = folder_.write("series.toml",
                                  "[domain]\nsize_m = [1.0, 1.0]\ncells = [48, 48]\ndepth_m = 0.5\n"
                                  "[waves]\nmodel = \"prescribed\"\nduration_s = 20\nfile = \"source/surface.pvd\"\n"
                                  "[output]\nevery_s = 0.02\ncheckpoint_every_s = 0.01\n");
    }
    fs::path last_ = folder_ / "source" / "surface" / "surface_000400.vti";
};

TEST_F(SeriesFaults, AnInputThatIsCutShortWhileItRunsStopsTheRun) {
    Child child = start();
    ASSERT_TRUE(wait_for_frames());
    fs::resize_file(last_, 5000);
    expect_exit_three(child, {"surface_000400.vti", "the last good checkpoint is"});
    expect_whole_files(out_);
}

TEST_F(SeriesFaults, AnInputThatIsReplacedWhileItRunsStopsTheRun) {
    Child child = start();
    ASSERT_TRUE(wait_for_frames());
    fs::copy_file(folder_ / "source" / "surface" / "surface_000399.vti", folder_ / "other.vti");
    fs::rename(folder_ / "other.vti", last_);
    expect_exit_three(child, {"surface_000400.vti: changed since the run started", "the last good checkpoint is"});
    expect_whole_files(out_);
}

TEST_F(SeriesFaults, AnInputThatChangedSinceTheCheckpointIsNotGoneOnWith) {
    Child child = start();
    ASSERT_TRUE(wait_for_frames());
    child.kill(SIGKILL);
    child.wait();
    std::ofstream(folder_ / "source" / "surface.pvd", std::ios::app) << "\n";
    const Outcome outcome = run_program(arguments(out_, {"--resume"}));
    EXPECT_EQ(outcome.exit, 2);
    expect_one_line(outcome.output, {"a data file differs"});
}

}  // namespace
}  // namespace waterlight::test
