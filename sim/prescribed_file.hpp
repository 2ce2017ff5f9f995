// A surface read from a .vti file, or from a .pvd series of them.
#pragma once

#include <filesystem>
#include <vector>

#include "sim/file_stamp.hpp"
#include "sim/surface.hpp"
#include "sim/vti_reader.hpp"

namespace waterlight {

/// Elevations at the times of the files, resampled to a grid. Two files at most are in memory.
class FileSeries {
  public:
    /// Reads the first file's elevation, so that a bad one is found before a run starts. Throws InputError naming the
    /// file where it cannot be read, holds no numbers, or does not cover `grid`.
    FileSeries(const std::filesystem::path& path, const Grid& grid, Boundary boundary);

    /// Sets the elevation (m) at time_s: linear in time between two files of a series; before the first and after the
    /// last the surface stays as it is there. A single .vti stands still. Throws InputError where a file that is read
    /// only now is not the one that was there at the start, or is no good.
    void elevation_at(double time_s, Field<float>& elevation_m);

  private:
    struct Loaded {
        std::size_t index = 0;
        Field<float> elevation_m;
    };

    const Field<float>& loaded(std::size_t index);

    std::vector<TimedFile> files_;
    std::vector<FileStamp> stamps_;  // of each file, at the start
    Grid grid_;
    Boundary boundary_;
    std::vector<Loaded> recent_;  // newest last
};

/// `from` at the cell centres of `grid`, bilinear between its own; over half a cell at the rim it wraps where a side is
/// periodic and keeps its last value elsewhere. Throws InputError, with `name` of the file, where `from` does not cover
/// `grid`.
Field<float> resampled(const VtiField& from, const Grid& grid, Boundary boundary, const std::string& name);

}  // namespace waterlight
