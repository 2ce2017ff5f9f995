// Time series at points: a table that grows by one row a frame.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "export/descriptor.hpp"

namespace waterlight {

/// A CSV file: "time_s,centre.elevation_m,..." and one row per frame, each number in the fewest digits that give it
/// back, NaN as "nan". Each row goes to the system in one piece, so that a process that is killed leaves whole rows.
class ProbeTable {
  public:
    /// Starts `path` anew with its header; `columns` are the names after time_s. Throws WorldError.
    ProbeTable(const std::filesystem::path& path, std::span<const std::string> columns);

    /// Goes on with the table that is at `path`: what it has beyond `size` bytes is cut off. Throws WorldError where it
    /// has less.
    ProbeTable(const std::filesystem::path& path, std::span<const std::string> columns, std::uint64_t size);

    /// Bytes written so far.
    std::uint64_t size() const { return size_; }

    /// `values`: one per column. Throws WorldError, and then the table ends with the row before.
    void append(double time_s, std::span<const double> values);

  private:
    void write_row(const std::string& row);

    std::size_t columns_;
    Descriptor file_;
    std::uint64_t size_ = 0;
};

}  // namespace waterlight
