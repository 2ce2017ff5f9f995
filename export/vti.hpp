// VTK image data: one frame of fields on a regular grid, as ParaView and Python open it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

namespace waterlight {

enum class Compression { none, lz4, zlib };

/// Numbers at the cell centres, x fastest. One component, or three for a vector, of which an empty one means zeros.
/// Borrows its values.
struct VtiArray {
    std::string name;
    std::vector<std::span<const float>> components;
};

/// A block of cells: counts, outer corner of the first cell, cell sizes, turned by angle_deg about the vertical through
/// the corner. Where one count is 0 it is a flat sheet across that axis.
struct VtiFrame {
    glm::ivec3 cells{1, 1, 0};
    glm::dvec3 origin_m{0, 0, 0};
    glm::dvec3 pitch_m{1, 1, 1};
    double angle_deg = 0;  ///< counter-clockwise
    double time_s = 0;
    std::vector<VtiArray> arrays;

    std::size_t values() const;  ///< of one component
    std::size_t bytes() const;   ///< of all arrays as written without compression
};

/// Writes `frame` to `path`, whole or not at all: cell data, raw appended, 64-bit sizes, time as the field array
/// "TimeValue". Throws WorldError naming the path and the reason.
void write_vti(const std::filesystem::path& path, const VtiFrame& frame, Compression compression);

}  // namespace waterlight
