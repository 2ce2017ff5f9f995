#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <thread>

#include "export/probes.hpp"
#include "export/series.hpp"
#include "sim/vti_reader.hpp"
#include "tests/unit/export_support.hpp"

namespace waterlight::testing {
namespace {

namespace fs = std::filesystem;

constexpr int nx = 200, ny = 150;

/// Writes frames until it is killed.
void write_for_ever(const fs::path& folder, Compression compression) {
    VtiSeries series(folder, "surface", compression);
    ProbeTable table(folder / "probes.csv", std::vector<std::string>{"a", "b"});
    for (int k = 0;; ++k) {
        const Field<float> field = noise(nx, ny, k);
        VtiFrame frame;
        frame.cells = {nx, ny, 0};
        frame.time_s = 0.1 * k;
        frame.arrays.push_back({"elevation", {field.values()}});
        series.write(frame);
        table.append(frame.time_s, std::vector{1.0 / 3, 2.0 / 3});
    }
}

/// When a series is killed: so long after it has so many files.
struct Moment {
    int files = 0;
    std::chrono::microseconds after{0};
};

void await_files(const fs::path& folder, int files) {
    const auto count = [&] {
        std::error_code none_yet;
        const fs::directory_iterator all(folder / "surface", none_yet);
        return none_yet ? 0 : static_cast<int>(std::distance(begin(all), end(all)));
    };
    // A writer that has stopped by itself writes no more of them; the kill finds that out.
    constexpr int most_waits = 20000;
    for (int k = 0; k < most_waits && count() < files; ++k) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

void write_and_kill(const fs::path& folder, Compression compression, Moment moment) {
    const pid_t child = ::fork();
    if (child == 0) {
        try {
            write_for_ever(folder, compression);
        } catch (...) {
            ::_exit(1);
        }
    }
    await_files(folder, moment.files);
    std::this_thread::sleep_for(moment.after);
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status)) << "it stopped before it was killed";
}

/// Frames found in the folder, each of them compared with what went in.
int whole_frames(const fs::path& folder) {
    int frames = 0;
    if (!fs::exists(folder / "surface")) return 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / "surface")) {
        const std::string name = entry.path().filename();
        if (name.front() == '.') continue;
        const VtiField field = read_vti(entry.path(), "elevation");
        const int k = std::stoi(name.substr(8, 6));
        EXPECT_TRUE(std::ranges::equal(field.values.values(), noise(nx, ny, k).values())) << name;
        EXPECT_EQ(field.time_s, 0.1 * k);
        ++frames;
    }
    return frames;
}

void expect_whole_rows(const fs::path& table) {
    const std::string text = bytes_of(table);
    if (text.empty()) return;
    EXPECT_EQ(text.back(), '\n');
    const auto count = [&](char c) { return std::count(text.begin(), text.end(), c); };
    EXPECT_EQ(count(','), 2 * count('\n'));
}

TEST(Series, KilledAtAnyMomentItHoldsWholeFilesOnly) {
    std::mt19937 random(20);
    int most = 0;
    for (int trial = 0; trial < 24; ++trial) {
        const TemporaryFolder folder;
        const auto compression = static_cast<Compression>(trial % 3);
        // Every fourth is well under way however slow the machine is.
        const Moment moment{trial % 4 == 3 ? 6 : 0, std::chrono::microseconds(random() % 40000)};
        write_and_kill(folder.path(), compression, moment);
        const int frames = whole_frames(folder.path());
        most = std::max(most, frames);
        expect_whole_rows(folder / "probes.csv");
        if (!fs::exists(folder / "surface.pvd")) {
            EXPECT_LE(frames, 1);
            continue;
        }
        const std::vector<TimedFile> named = read_pvd(folder / "surface.pvd");
        EXPECT_LE(static_cast<int>(named.size()), frames);
        EXPECT_GE(static_cast<int>(named.size()), frames - 1) << "at most the last frame is not yet named";
        for (std::size_t k = 0; k < named.size(); ++k) {
            EXPECT_EQ(named[k].time_s, 0.1 * static_cast<double>(k));
            EXPECT_TRUE(fs::exists(named[k].path)) << named[k].path;
        }
    }
    EXPECT_GT(most, 3) << "the trials must catch series that had begun";
}

}  // namespace
}  // namespace waterlight::testing
