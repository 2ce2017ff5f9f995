#include "sim/ndbc_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include "sim/error.hpp"

namespace waterlight {

namespace {

/// What a line of a file says of one time.
struct Row {
    int line = 0;
    std::vector<double> frequency_hz, value;
};

/// One file: its rows by time, which sort as text.
struct Table {
    std::filesystem::path path;
    std::map<std::string, Row> rows;
};

/// What a file is called and holds.
struct Quantity {
    const char* suffix;
    double lowest, highest;
    bool may_be_missing;
    int columns_before;  ///< between the time and the first value
};

constexpr std::array<Quantity, 5> quantities{{{".data_spec", 0, 1e6, false, 1},
                                              {".swdir", 0, 360, true, 0},
                                              {".swdir2", 0, 360, true, 0},
                                              {".swr1", 0, 1, true, 0},
                                              {".swr2", 0, 1, true, 0}}};

[[noreturn]] void fail(const std::filesystem::path& path, int line, const std::string& what) {
    throw InputError(fmt::format("{}:{}: {}", path.string(), line, what));
}

std::string read_time(std::istringstream& text) {
    int year = 0, month = 0, day = 0, hour = 0, minute = 0;
    text >> year >> month >> day >> hour >> minute;
    const bool valid = text && year >= 1970 && month >= 1 && month <= 12 && day >= 1 && day <= 31 && hour >= 0 &&
                       hour <= 23 && minute >= 0 && minute <= 59;
    return valid ? fmt::format("{:04}-{:02}-{:02} {:02}:{:02}", year, month, day, hour, minute) : "";
}

bool is_missing(double value) { return value >= 999; }

Row read_row(std::istringstream& text, const Quantity& quantity, const std::filesystem::path& path, int line) {
    Row row;
    row.line = line;
    double skipped = 0;
    for (int i = 0; i < quantity.columns_before; ++i) text >> skipped;
    double value = 0, frequency = 0;
    while (text >> std::ws && !text.eof()) {
        char open = 0, close = 0;
        if (!(text >> value >> open >> frequency >> close) || open != '(' || close != ')')
            fail(path, line,
                 fmt::format("expected pairs \"value (frequency)\", but pair {} is not one", row.value.size() + 1));
        const bool missing = is_missing(value);
        if (!missing && !(value >= quantity.lowest && value <= quantity.highest))
            fail(path, line,
                 fmt::format("value {} at {} Hz is outside [{}, {}]", value, frequency, quantity.lowest,
                             quantity.highest));
        if (frequency <= (row.frequency_hz.empty() ? 0 : row.frequency_hz.back()))
            fail(path, line, fmt::format("frequency {} Hz is not above the one before it", frequency));
        row.frequency_hz.push_back(frequency);
        row.value.push_back(missing ? std::numeric_limits<double>::quiet_NaN() : value);
    }
    if (row.value.size() < 3)
        fail(path, line, fmt::format("has {} frequencies; a spectrum needs 3 or more", row.value.size()));
    return row;
}

Table read_table(const std::filesystem::path& stem, const Quantity& quantity) {
    Table table;
    table.path = stem.string() + quantity.suffix;
    std::ifstream file(table.path);
    if (!file) throw InputError(fmt::format("{}: cannot be opened", table.path.string()));
    int line = 0;
    for (std::string content; std::getline(file, content);) {
        ++line;
        if (content.empty() || content.front() == '#' || content == "\r") continue;
        std::istringstream text(content);
        const std::string time = read_time(text);
        if (time.empty()) fail(table.path, line, "expected a line to begin with year, month, day, hour and minute");
        table.rows[time] = read_row(text, quantity, table.path, line);
    }
    if (table.rows.empty()) throw InputError(fmt::format("{}: holds no record", table.path.string()));
    return table;
}

bool is_complete(const Row& row) {
    return std::none_of(row.value.begin(), row.value.end(), [](double v) { return std::isnan(v); });
}

std::string newest_complete(const std::vector<Table>& tables) {
    const auto& spectra = tables.front().rows;
    for (auto row = spectra.rbegin(); row != spectra.rend(); ++row) {
        const bool everywhere = std::all_of(tables.begin(), tables.end(),
                                            [&](const Table& table) { return table.rows.contains(row->first); });
        if (everywhere && is_complete(row->second)) return row->first;
    }
    throw InputError(
        fmt::format("{}: no record of it is complete and in the four other files too", tables.front().path.string()));
}

const Row& row_at(const Table& table, const std::string& time) {
    const auto found = table.rows.find(time);
    if (found != table.rows.end()) return found->second;
    throw InputError(fmt::format("{}: has no record of \"{}\"; its records go from \"{}\" to \"{}\"",
                                 table.path.string(), time, table.rows.begin()->first, table.rows.rbegin()->first));
}

}  // namespace

NdbcRecord read_ndbc(const std::filesystem::path& stem, const std::string& time) {
    std::vector<Table> tables;
    for (const Quantity& quantity : quantities) tables.push_back(read_table(stem, quantity));
    NdbcRecord record;
    record.time = time.empty() ? newest_complete(tables) : time;
    const std::array<std::vector<double>*, 5> columns{&record.density, &record.alpha1_deg, &record.alpha2_deg,
                                                      &record.r1, &record.r2};
    record.frequency_hz = row_at(tables.front(), record.time).frequency_hz;
    for (std::size_t i = 0; i < tables.size(); ++i) {
        const Row& row = row_at(tables[i], record.time);
        if (row.frequency_hz != record.frequency_hz)
            fail(tables[i].path, row.line,
                 fmt::format("its frequencies are not those of {}", tables.front().path.string()));
        if (!quantities[i].may_be_missing && !is_complete(row))
            fail(tables[i].path, row.line, "a density is missing (999)");
        *columns[i] = row.value;
    }
    return record;
}

}  // namespace waterlight
