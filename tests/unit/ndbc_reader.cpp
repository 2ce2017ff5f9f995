// NDBC's five files, whole and damaged.
#include "sim/ndbc_reader.hpp"

#include <cmath>

#include "sim/error.hpp"
#include "tests/support/ndbc_files.hpp"

namespace waterlight::testing {
namespace {

using NdbcReader = NdbcFiles;

/// The message of the error that reading gives.
std::string complaint(const std::filesystem::path& stem, const std::string& time = "") {
    try {
        read_ndbc(stem, time);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

#define EXPECT_NAMES(text, ...)                   \
    for (const std::string& word : {__VA_ARGS__}) \
    EXPECT_NE((text).find(word), std::string::npos) << word << " is not in: " << (text)

TEST_F(NdbcReader, ReadsARecord) {
    write_good();
    const NdbcRecord record = read_ndbc(stem(), "");
    EXPECT_EQ(record.time, "2024-03-05 12:00");
    EXPECT_EQ(record.frequency_hz, (std::vector<double>{0.1, 0.11, 0.13, 0.15}));
    EXPECT_EQ(record.density, (std::vector<double>{0.4, 2, 1, 0.1}));
    EXPECT_EQ(record.alpha1_deg[3], 180);
    EXPECT_EQ(record.r1[0], 0.8);
    EXPECT_EQ(record.r2[3], 0.3);
    EXPECT_TRUE(std::isnan(record.alpha1_deg[2]) && std::isnan(record.r2[2]));
}

TEST_F(NdbcReader, TakesTheNewestRecordThatIsComplete) {
    write_good();
    write(".data_spec",
          "2024 03 05 13 00 0.1 0.5 (0.100) 2.000 (0.110) 1.000 (0.130) 0.100 (0.150)\n"
          "2024 03 05 12 00 0.1 0.4 (0.100) 2.000 (0.110) 1.000 (0.130) 0.100 (0.150)\n"
          "2024 03 05 11 00 0.1 0.3 (0.100) 2.000 (0.110) 1.000 (0.130) 0.100 (0.150)\n");
    EXPECT_EQ(read_ndbc(stem(), "").density[0], 0.4);
    EXPECT_NAMES(complaint(stem(), "2024-03-05 11:00"), "99999.swdir", "2024-03-05 11:00", "2024-03-05 12:00");
    EXPECT_NAMES(complaint(stem(), "2020-01-01 00:00"), "99999.data_spec", "2020-01-01 00:00");
}

TEST_F(NdbcReader, NamesTheFileThatIsAbsent) {
    EXPECT_NAMES(complaint(stem()), "99999.data_spec", "cannot be opened");
    write_good();
    std::filesystem::remove(stem().string() + ".swr2");
    EXPECT_NAMES(complaint(stem()), "99999.swr2", "cannot be opened");
    write(".swr2", "");
    EXPECT_NAMES(complaint(stem()), "99999.swr2", "no record");
}

TEST_F(NdbcReader, NamesFileAndLineOfWhatIsWrong) {
    const auto damaged = [&](const std::string& suffix, const std::string& text) {
        write_good();
        write(suffix, text);
        return complaint(stem());
    };
    EXPECT_NAMES(damaged(".swr1", "yesterday\n"), "99999.swr1:2", "year");
    EXPECT_NAMES(damaged(".swr1", "2024 13 05 12 00 0.8 (0.1)\n"), "99999.swr1:2", "year");
    EXPECT_NAMES(damaged(".swr1", "2024 03 05 12 00 0.80 (0.100) 0.80 0.110 0.1 (0.130)\n"), "99999.swr1:2", "pair 2");
    EXPECT_NAMES(damaged(".swr1", "2024 03 05 12 00 0.80 (0.100)\n"), "99999.swr1:2", "1 frequencies");
    EXPECT_NAMES(damaged(".swr1", "2024 03 05 12 00 1.80 (0.100) 0.8 (0.110) 0.8 (0.130)\n"), "99999.swr1:2", "1.8");
    EXPECT_NAMES(damaged(".swdir", "2024 03 05 12 00 -7 (0.100) 0.8 (0.110) 0.8 (0.130)\n"), "99999.swdir:2", "-7");
    EXPECT_NAMES(damaged(".data_spec", "2024 03 05 12 00 0.1 1 (0.100) 1 (0.090) 1 (0.130)\n"), "99999.data_spec:2",
                 "0.09");
    EXPECT_NAMES(damaged(".swdir2", "2024 03 05 12 00 9 (0.100) 9 (0.110) 9 (0.130) 9 (0.160)\n"), "99999.swdir2:2",
                 "99999.data_spec");
    EXPECT_NAMES(damaged(".data_spec", "2024 03 05 12 00 0.1 999 (0.100) 1 (0.110) 1 (0.130) 1 (0.150)\n"),
                 "99999.data_spec", "complete");
}

}  // namespace
}  // namespace waterlight::testing
