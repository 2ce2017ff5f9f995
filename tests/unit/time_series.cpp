// Time series: values between the times, files whole and damaged.
#include "sim/time_series.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "tests/support/damaged_files.hpp"

namespace waterlight::testing {
namespace {

/// What reading a file of this text complains of, without the file's name.
std::string complaint(const std::string& text, double scale = 1) {
    const TemporaryFolder folder;
    const auto path = folder / "s.txt";
    put_bytes(path, text);
    const std::string whole = complaint_of(path, [&] { read_time_series(path, scale); });
    return whole.empty() ? whole : whole.substr(path.string().size());
}

TimeSeries series_in(const std::string& text, double scale = 1) {
    const TemporaryFolder folder;
    put_bytes(folder / "s.csv", text);
    return read_time_series(folder / "s.csv", scale);
}

TEST(TimeSeries, IsLinearBetweenItsTimesAndConstantBeyond) {
    const TimeSeries series{{1, 2, 4}, {10, 20, 0}};
    EXPECT_EQ(series.at(-5), 10);
    EXPECT_EQ(series.at(1), 10);
    EXPECT_EQ(series.at(1.25), 12.5);
    EXPECT_EQ(series.at(2), 20);
    EXPECT_EQ(series.at(3), 10);
    EXPECT_EQ(series.at(4), 0);
    EXPECT_EQ(series.at(1e9), 0);
    EXPECT_EQ(series.end_s(), 4);
}

TEST(TimeSeries, HasTheSlopeOfTheIntervalThatBegins) {
    const TimeSeries series{{1, 2, 4}, {10, 20, 0}};
    EXPECT_EQ(series.rate_at(0.999), 0);
    EXPECT_EQ(series.rate_at(1), 10);
    EXPECT_EQ(series.rate_at(1.5), 10);
    EXPECT_EQ(series.rate_at(2), -10);
    EXPECT_EQ(series.rate_at(4), 0);
    EXPECT_EQ(series.rate_at(5), 0);
}

TEST(TimeSeries, MayHoldOneValue) {
    const TimeSeries series = constant_series(3.5);
    for (const double time_s : {-1.0, 0.0, 1.0}) {
        EXPECT_EQ(series.at(time_s), 3.5);
        EXPECT_EQ(series.rate_at(time_s), 0);
    }
}

TEST(TimeSeriesReader, TakesBlanksCommasHeadingsAndComments) {
    const std::string byte_order_mark = "\xef\xbb\xbf";
    for (const std::string& text :
         {std::string("time(s)\twater surface(m)\n0.0E+00\t-1.5\n5.0E-02\t+2\n"), std::string("0,-1.5\n0.05 , 2\n"),
          std::string("# made up\r\nt,eta\r\n\r\n 0 -1.5 \r\n# half way\r\n0.05\t2"),
          byte_order_mark + "0 -1.5\n.05 2\n\n"}) {
        const TimeSeries series = series_in(text, 2);
        EXPECT_EQ(series.time_s, (std::vector<double>{0, 0.05})) << text;
        EXPECT_EQ(series.value, (std::vector<double>{-3, 4})) << text;
    }
}

TEST(TimeSeriesReader, SaysWhatIsWrongAndWhere) {
    EXPECT_EQ(complaint("t,eta\n0,1\n1,2x\n"), ":3: two numbers are wanted, time (s) and value; found \"1,2x\"");
    EXPECT_EQ(complaint("0 1\n1 2 3\n"), ":2: two numbers are wanted, time (s) and value; found \"1 2 3\"");
    EXPECT_EQ(complaint("0 1 2\n1 2 3\n"), ":1: two numbers are wanted, time (s) and value; found \"0 1 2\"");
    EXPECT_EQ(complaint("0 1\n1\n"), ":2: two numbers are wanted, time (s) and value; found \"1\"");
    EXPECT_EQ(complaint("0 1\n1,2,\n"), ":2: two numbers are wanted, time (s) and value; found \"1,2,\"");
    EXPECT_EQ(complaint("0 1\n1,,2\n"), ":2: two numbers are wanted, time (s) and value; found \"1,,2\"");
    EXPECT_EQ(complaint("0 1\n1 1e999\n"), ":2: two numbers are wanted, time (s) and value; found \"1 1e999\"");
    EXPECT_EQ(complaint("0 1\nend\x01\n"), ":2: two numbers are wanted, time (s) and value; found \"end?\"");
    EXPECT_EQ(complaint("0 nan\n"), ":1: finite numbers are wanted; found time 0 s and value nan");
    EXPECT_EQ(complaint("0 1\ninf 1\n"), ":2: finite numbers are wanted; found time inf s and value 1");
    EXPECT_EQ(complaint("0 1e300\n", 1e300), ":1: finite numbers are wanted; found time 0 s and value inf");
    EXPECT_EQ(complaint("0 1\n1 2\n1 3\n"), ":3: times must increase; found 1 s after 1 s");
    EXPECT_EQ(complaint("0 1\n-1 2\n"), ":2: times must increase; found -1 s after 0 s");
    EXPECT_EQ(complaint(""), ": holds no line of two numbers, time (s) and value");
    EXPECT_EQ(complaint("time value\n"), ": holds no line of two numbers, time (s) and value");
    EXPECT_EQ(complaint("0 1\n" + std::string(70000, '1')),
              ":2: is longer than 65536 characters; a line of a few numbers is wanted");
}

TEST(TimeSeriesReader, SaysThatThereIsNoFile) {
    const TemporaryFolder folder;
    const auto missing = folder / "missing.txt";
    EXPECT_EQ(complaint_of(missing, [&] { read_time_series(missing); }),
              missing.string() + ": cannot be read: No such file");
    EXPECT_EQ(complaint_of(folder.path(), [&] { read_time_series(folder.path()); }),
              folder.path().string() + ": is no file of text");
}

TEST(TimeSeriesReader, SurvivesDamage) {
    const TemporaryFolder folder;
    std::string whole = "time(s)\televation(m)\n";
    for (int i = 0; i < 30; ++i) whole += fmt::format("{:.5E}\t{:.5E}\n", 0.05 * i, 1e-3 * (i % 7));
    const auto path = folder / "s.txt";
    expect_survives_damage(path, whole, 5000, [&] { read_time_series(path); });
}

TEST(TimeSeriesReader, ReadsTheIncidentWaveOfMonai) {
    const char* data = std::getenv("WATERLIGHT_DATA");
    if (data == nullptr) GTEST_SKIP() << "WATERLIGHT_DATA is not set";
    const TimeSeries series = read_time_series(std::filesystem::path(data) / "nthmp" / "monai_incident_wave.txt");
    ASSERT_EQ(series.time_s.size(), 451U);
    EXPECT_EQ(series.time_s[1], 0.05);
    EXPECT_EQ(series.value[0], -1.19e-5);
    EXPECT_EQ(series.end_s(), 22.5);
    EXPECT_EQ(series.value.back(), 1.0451e-3);
}

}  // namespace
}  // namespace waterlight::testing
