#include "export/probes.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <system_error>

#include "export/atomic_file.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

const std::filesystem::path& with_folder(const std::filesystem::path& path) {
    std::error_code error;
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
    if (error) throw_cannot_write(path, error.message());
    return path;
}

/// A NaN has a sign, which says nothing here.
std::string number(double value) { return std::isnan(value) ? "nan" : fmt::format("{}", value); }

/// RFC 4180: quoted where it must be, quotes doubled.
std::string csv_text(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

}  // namespace

ProbeTable::ProbeTable(const std::filesystem::path& path, std::span<const std::string> columns)
    : columns_(columns.size()), file_(with_folder(path), path, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND) {
    std::string header = "time_s";
    for (const std::string& column : columns) header += ',' + csv_text(column);
    write_row(header + '\n');
}

ProbeTable::ProbeTable(const std::filesystem::path& path, std::span<const std::string> columns, std::uint64_t size)
    : columns_(columns.size()), file_(path, path, O_WRONLY | O_APPEND), size_(size) {
    std::error_code error;
    const std::uintmax_t there = std::filesystem::file_size(path, error);
    if (error || there < size)
        throw WorldError(fmt::format("cannot go on with {}: rows that were written are missing", path.string()));
    file_.truncate(size);
}

void ProbeTable::append(double time_s, std::span<const double> values) {
    assert(values.size() == columns_);
    std::string row = number(time_s);
    for (const double value : values) row += ',' + number(value);
    write_row(row + '\n');
}

void ProbeTable::write_row(const std::string& row) {
    try {
        file_.write(row);
        size_ += row.size();
    } catch (...) {
        file_.truncate(size_);
        throw;
    }
}

}  // namespace waterlight
