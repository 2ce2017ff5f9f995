// The results of a sweep as people and spreadsheets read them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/sweep/front.hpp"
#include "app/sweep/result.hpp"
#include "app/sweep/settings.hpp"

namespace waterlight {

/// One setting that has run.
struct TableRow {
    std::size_t number = 0;  ///< of the setting, from 1
    const Setting* setting = nullptr;
    SettingResult result;
};

/// Rows in order of time, those that failed at the end; and what the caller wants to know of them.
struct Table {
    std::filesystem::path scenario;
    std::vector<Variation> variations;
    std::size_t settings = 0;  ///< rows or not
    glm::ivec2 raster{0, 0};
    glm::ivec2 points{1, 1};
    std::vector<double> times_s;
    std::optional<double> tolerance;
    std::vector<TableRow> rows;
    std::vector<CostAndError> costs;  ///< of the rows
    std::vector<std::size_t> front;   ///< rows, in order of time
};

/// Sorts the rows and finds the front.
void finish(Table& table);

/// Whether a row meets the tolerance; true where none is asked for.
bool meets_tolerance(const Table& table);
/// One or two lines: the cheapest setting that meets the tolerance, or that none does and which is closest; empty where
/// no tolerance is asked for or nothing has run.
std::string recommendation(const Table& table);
/// What errors are relative to, in a few lines.
std::string explanation(const Table& table);

/// Aligned for a terminal, and as Markdown; the front is marked with *.
std::string text_of(const Table& table);
std::string markdown_of(const Table& table);
/// One row a setting, each number in the fewest digits that give it back; nan where there is none.
std::string csv_of(const Table& table);

}  // namespace waterlight
