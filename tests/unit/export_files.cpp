#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "export/atomic_file.hpp"
#include "export/exr.hpp"
#include "export/grey16.hpp"
#include "export/probes.hpp"
#include "export/report.hpp"
#include "export/vti.hpp"
#include "sim/error.hpp"
#include "tests/unit/export_support.hpp"

namespace waterlight::testing {
namespace {

namespace fs = std::filesystem;

/// Each way to write a file, of the same noisy field.
struct Writer {
    std::string name;
    std::function<void(const fs::path&)> write;
};

std::vector<Writer> writers() {
    static const Field<float> field = noise(96, 64, 1);
    const auto vti = [](const fs::path& path, Compression compression) {
        VtiFrame frame;
        frame.cells = {field.nx(), field.ny(), 0};
        frame.arrays.push_back({"elevation", {field.values()}});
        frame.arrays.push_back({"velocity", {field.values(), {}, field.values()}});
        write_vti(path, frame, compression);
    };
    return {{"bytes", [](const fs::path& path) { write_file(path, std::string(20000, 'x')); }},
            {"vti", [=](const fs::path& path) { vti(path, Compression::none); }},
            {"vti zlib", [=](const fs::path& path) { vti(path, Compression::zlib); }},
            {"vti lz4", [=](const fs::path& path) { vti(path, Compression::lz4); }},
            {"grey",
             [](const fs::path& path) {
                 write_grey16(path, field, {-1, 1}, "elevation", "m");
             }},
            {"exr", [](const fs::path& path) { write_exr(path, field, {}); }},
            {"json", [](const fs::path& path) { write_json(path, nlohmann::json(std::vector<int>(3000, 7))); }}};
}

/// What `write` throws as a WorldError; empty if nothing.
std::string world_error(const std::function<void()>& write) {
    try {
        write();
    } catch (const WorldError& error) {
        return error.what();
    }
    return "";
}

TEST(AtomicFile, ReplacesTheWholeContentAndMakesFolders) {
    const TemporaryFolder folder;
    const fs::path path = folder / "a/b/file.txt";
    write_file(path, "first, longer");
    write_file(path, "second");
    EXPECT_EQ(bytes_of(path), "second");
    EXPECT_EQ(folder.entries(), 3) << "a, b and the file";
}

TEST(AtomicFile, IsRemovedWithoutCommit) {
    const TemporaryFolder folder;
    put_bytes(folder / "file.txt", "old");
    {
        const PendingFile pending(folder / "file.txt");
        put_bytes(pending.temporary(), "half");
        EXPECT_EQ(pending.temporary().parent_path(), folder.path());
        EXPECT_EQ(pending.temporary().filename().string().front(), '.');
    }
    EXPECT_EQ(bytes_of(folder / "file.txt"), "old");
    EXPECT_EQ(folder.entries(), 1);
}

/// The disk ends after some bytes, wherever that is: nothing is left, what was there stays, and the error says so.
TEST(AtomicFile, AFullDiskLeavesNothing) {
    for (const Writer& writer : writers()) {
        const TemporaryFolder folder;
        const fs::path path = folder / "out.bin";
        writer.write(path);
        const auto size = static_cast<rlim_t>(fs::file_size(path));
        put_bytes(path, "old");
        for (const rlim_t room :
             {rlim_t{0}, rlim_t{1}, size / 7, size / 3, size / 2, size - 4097, size - 100, size - 1}) {
            const int status = in_child([&] {
                ::signal(SIGXFSZ, SIG_IGN);
                const rlimit limit{room, room};
                ::setrlimit(RLIMIT_FSIZE, &limit);
                const std::string error = world_error([&] { writer.write(path); });
                return error.find(path.string()) == std::string::npos ? 1 : 0;
            });
            EXPECT_EQ(status, 0) << writer.name << " with room for " << room << " of " << size << " bytes";
            EXPECT_EQ(bytes_of(path), "old") << writer.name;
            EXPECT_EQ(folder.entries(), 1) << writer.name;
        }
    }
}

TEST(AtomicFile, AReadOnlyFolderIsNamedWithTheReason) {
    for (const Writer& writer : writers()) {
        const TemporaryFolder folder;
        ASSERT_EQ(::chmod(folder.path().c_str(), 0555), 0);
        const int status = in_child([&] {
            if (::geteuid() == 0 && ::setuid(65534) != 0) return 2;
            const std::string error = world_error([&] { writer.write(folder / "out.bin"); });
            const bool says_all = error.find((folder / "out.bin").string()) != std::string::npos &&
                                  error.find("ermission denied") != std::string::npos;
            return says_all ? 0 : 1;
        });
        EXPECT_EQ(status, 0) << writer.name;
        EXPECT_EQ(folder.entries(), 0) << writer.name;
    }
}

TEST(AtomicFile, AFileInPlaceOfTheFolderIsAnError) {
    const TemporaryFolder folder;
    put_bytes(folder / "file", "");
    for (const Writer& writer : writers()) {
        EXPECT_NE(world_error([&] { writer.write(folder / "file/out.bin"); }).find("Not a directory"),
                  std::string::npos)
            << writer.name;
    }
}

TEST(Report, NumbersThatAreNotFiniteBecomeNull) {
    const TemporaryFolder folder;
    const double infinity = std::numeric_limits<double>::infinity();
    nlohmann::ordered_json json;
    json["z"] = std::nan("");
    json["a"] = {1.5, -infinity, infinity};
    json["text"] = "caf\xe9";
    write_json(folder / "report.json", json);
    EXPECT_EQ(bytes_of(folder / "report.json"),
              "{\n  \"z\": null,\n  \"a\": [\n    1.5,\n    null,\n    null\n  ],\n  \"text\": \"caf\ufffd\"\n}\n");
}

TEST(Probes, NumbersComeBackExactly) {
    const TemporaryFolder folder;
    const std::vector<std::string> columns{"centre.elevation_m", "left, \"far\".elevation_m"};
    ProbeTable table(folder / "out/probes.csv", columns);
    table.append(0, std::vector{0.1, -1e-300});
    table.append(1.0 / 3, std::vector{-std::nan(""), 2.0 / 3});
    EXPECT_EQ(bytes_of(folder / "out/probes.csv"),
              "time_s,centre.elevation_m,\"left, \"\"far\"\".elevation_m\"\n"
              "0,0.1,-1e-300\n"
              "0.3333333333333333,nan,0.6666666666666666\n")
        << "each row is there as soon as it is appended";
}

TEST(Probes, AFullDiskLeavesWholeRows) {
    const TemporaryFolder folder;
    const fs::path path = folder / "probes.csv";
    const int status = in_child([&] {
        ::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{100, 100};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        ProbeTable table(path, std::vector<std::string>{"a"});
        const std::string error = world_error([&] {
            for (int i = 0; i < 100; ++i) table.append(i, std::vector{1.0 / (i + 3)});
        });
        return error.find(path.string()) == std::string::npos ? 1 : 0;
    });
    EXPECT_EQ(status, 0);
    const std::string text = bytes_of(path);
    EXPECT_GT(text.size(), 60U);
    EXPECT_EQ(text.back(), '\n');
}

}  // namespace
}  // namespace waterlight::testing
