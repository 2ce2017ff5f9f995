#include "app/sweep/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace waterlight {

namespace {

using Cells = std::vector<std::string>;

CostAndError cost_of(const SettingResult& r) {
    if (!r.failed.empty()) return {std::nan(""), std::nan("")};
    return {r.wall_s.total(), r.errors.together()};
}

std::string percent_or_dash(double fraction) {
    return std::isfinite(fraction) ? fmt::format("{:.3g} %", 100 * fraction) : std::string("-");
}

std::string seconds(double s) { return fmt::format("{:.3g}", s); }

bool has_floor(const Table& table) { return table.raster.x > 0; }

Cells header_of(const Table& table) {
    Cells header{"", "#"};
    for (const Variation& variation : table.variations) header.push_back(variation.key);
    header.push_back("waves, s");
    if (has_floor(table)) header.insert(header.end(), {"floor, s", "both, s"});
    header.push_back("error of waves");
    if (has_floor(table)) header.insert(header.end(), {"of light", "together"});
    return header;
}

Cells cells_of(const Table& table, std::size_t i) {
    const TableRow& row = table.rows[i];
    const SettingResult& r = row.result;
    const bool on_front = std::find(table.front.begin(), table.front.end(), i) != table.front.end();
    Cells cells{on_front ? "*" : "", fmt::format("{}", row.number)};
    cells.insert(cells.end(), row.setting->values.begin(), row.setting->values.end());
    if (!r.failed.empty()) {
        cells.push_back("failed: " + r.failed);
        return cells;
    }
    cells.push_back(seconds(r.wall_s.waves));
    if (has_floor(table)) cells.insert(cells.end(), {seconds(r.wall_s.floor), seconds(r.wall_s.total())});
    cells.push_back(percent_or_dash(r.errors.waves));
    if (has_floor(table)) cells.insert(cells.end(), {percent_or_dash(r.errors.light), percent_or_dash(r.errors.both)});
    return cells;
}

/// Fields with a comma, a quotation mark or an end of line are quoted (RFC 4180).
std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

std::string run_command(const Table& table, const TableRow& row) {
    std::string command = fmt::format("./waterlight run {}", table.scenario.string());
    for (const std::string& override : row.result.overrides) command += fmt::format(" --set '{}'", override);
    return command;
}

}  // namespace

void finish(Table& table) {
    const auto time = [](const TableRow& row) {
        const double s = cost_of(row.result).time_s;
        return std::isfinite(s) ? s : std::numeric_limits<double>::infinity();
    };
    std::stable_sort(table.rows.begin(), table.rows.end(),
                     [&](const TableRow& a, const TableRow& b) { return time(a) < time(b); });
    table.costs.clear();
    for (const TableRow& row : table.rows) table.costs.push_back(cost_of(row.result));
    table.front = pareto_front(table.costs);
}

bool meets_tolerance(const Table& table) {
    return !table.tolerance || cheapest_within(table.costs, *table.tolerance).has_value();
}

std::string recommendation(const Table& table) {
    const std::optional<std::size_t> best = least_wrong(table.costs);
    if (!table.tolerance || !best) return {};
    const std::optional<std::size_t> cheapest = cheapest_within(table.costs, *table.tolerance);
    const TableRow& row = table.rows[cheapest.value_or(*best)];
    const std::string says =
        cheapest ? fmt::format("The cheapest setting within {} is", percent_or_dash(*table.tolerance))
                 : fmt::format("No setting is within {}; the closest is", percent_or_dash(*table.tolerance));
    return fmt::format("{} #{}: {} ({} in {} s)\n  {}\n", says, row.number, text_of(table.variations, *row.setting),
                       percent_or_dash(row.result.errors.together()), seconds(row.result.wall_s.total()),
                       run_command(table, row));
}

std::string explanation(const Table& table) {
    std::set<std::string> references, devices;
    for (const TableRow& row : table.rows) {
        references.insert(row.result.reference);
        if (!row.result.device.empty())
            devices.insert(
                fmt::format("{} on {} with {} threads", row.result.backend, row.result.device, row.result.threads));
    }
    std::string text =
        fmt::format("Errors are relative RMSE at t = {:.4g} s. Waves: elevation at {} x {} points against {}.",
                    fmt::join(table.times_s, ", "), table.points.x, table.points.y, fmt::join(references, "; "));
    if (has_floor(table))
        text += fmt::format(
            " Light: the map against the truth below the setting's own surface; together: below those waves; both on "
            "averages over {} x {} pixels; what is below the convergence of the light tells nothing.",
            table.raster.x, table.raster.y);
    text += fmt::format(
        " Times are of the whole run without writing files, {}. * marks the front: nothing is both faster and less "
        "wrong.",
        fmt::join(devices, "; "));
    return text + "\n";
}

std::string text_of(const Table& table) {
    std::vector<Cells> lines{header_of(table)};
    for (std::size_t i = 0; i < table.rows.size(); ++i) lines.push_back(cells_of(table, i));
    std::vector<std::size_t> widths(lines.front().size(), 0);
    for (const Cells& line : lines)
        for (std::size_t c = 0; c < line.size(); ++c)
            if (!line[c].starts_with("failed: ")) widths[c] = std::max(widths[c], line[c].size());
    std::string text;
    for (const Cells& line : lines) {
        std::string row;
        for (std::size_t c = 0; c < line.size(); ++c) row += fmt::format("{:<{}}  ", line[c], widths[c]);
        row.erase(row.find_last_not_of(' ') + 1);
        text += row + "\n";
    }
    return text;
}

std::string markdown_of(const Table& table) {
    const Cells header = header_of(table);
    std::string text = fmt::format("# Sweep of {}\n\n{} of {} settings.\n\n", table.scenario.filename().string(),
                                   table.rows.size(), table.settings);
    text += fmt::format("| {} |\n|", fmt::join(header, " | "));
    for (std::size_t c = 0; c < header.size(); ++c) text += "---|";
    text += "\n";
    for (std::size_t i = 0; i < table.rows.size(); ++i)
        text += fmt::format("| {} |\n", fmt::join(cells_of(table, i), " | "));
    text += fmt::format("\n{}", explanation(table));
    if (const std::string best = recommendation(table); !best.empty()) text += fmt::format("\n{}", best);
    return text + "\n![time against error](sweep.svg)\n";
}

std::string csv_of(const Table& table) {
    Cells header{"setting"};
    for (const Variation& variation : table.variations) header.push_back(csv_field(variation.key));
    std::string text = fmt::format("{},waves_s,floor_s,total_s,error_waves,error_light,error_together,front,failed\n",
                                   fmt::join(header, ","));
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const TableRow& row = table.rows[i];
        const SettingResult& r = row.result;
        Cells fields{fmt::format("{}", row.number)};
        for (const std::string& value : row.setting->values) fields.push_back(csv_field(value));
        for (const double value :
             {r.wall_s.waves, r.wall_s.floor, r.wall_s.total(), r.errors.waves, r.errors.light, r.errors.both})
            fields.push_back(fmt::format("{}", value));
        const bool on_front = std::find(table.front.begin(), table.front.end(), i) != table.front.end();
        fields.emplace_back(on_front ? "1" : "0");
        fields.push_back(csv_field(r.failed));
        text += fmt::format("{}\n", fmt::join(fields, ","));
    }
    return text;
}

}  // namespace waterlight
