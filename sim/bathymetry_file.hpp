// Ground heights from files, resampled to a grid.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "sim/field.hpp"
#include "sim/grid.hpp"

namespace waterlight {

/// Whether a file's numbers are heights or depths.
enum class Positive { up, down };

/// Cells of the domain for which a file has no data: an error, or the value of the nearest data.
enum class OutsideFile { refuse, extend };

/// A file of ground heights, and how it lies in the domain. By its extension it is
/// .vti: a scalar array on the cells or points of an image; NaN is no data;
/// .asc:  an ESRI ASCII grid, with xllcorner or xllcenter and likewise y, cellsize or dx and dy, and NODATA_value,
/// which
///        is -9999 where the header has none;
/// .xyz, .txt, .csv, .dat: lines "x y z" or "x,y,z", the points of a lattice of evenly spaced columns and rows (to a
///        twentieth of the spacing) in any order. Lines before the first of three numbers are a heading, lines that
///        begin with # are comments; NaN for z, and a point that is missing, are no data. Scattered points are refused.
struct GroundFile {
    std::filesystem::path path;
    std::string array = "bed";                        ///< of a .vti
    std::optional<Positive> positive = std::nullopt;  ///< none: up, and down for the array "depth"
    double datum_m = 0;                               ///< height of the still level, upwards, in the file's own datum
    glm::dvec2 offset_m{0, 0};                        ///< where the file's origin lies in the domain
    OutsideFile outside = OutsideFile::refuse;
};

/// Heights (m) above the still level, for each cell of the grid. A number of the file becomes +-number - datum_m in
/// double before anything else is done with it, so that high datums cost no digits. Between the file's points the
/// ground is bilinear, and constant over half a spacing beyond the outermost. Along an axis on which the points are
/// closer than the cells, a cell gets the exact mean of that ground over its width: the volume of ground in the domain
/// is that of the file. Along an axis on which they are not, a cell gets the ground at its centre; points that are the
/// cell centres are reproduced exactly. Linear ground is exact either way; the error is of second order in the wider of
/// both spacings.
///
/// With `extend`, a cell with part of its data gets the mean of those, and a cell without any the value of the cell
/// with data that is the fewest steps away.
///
/// Text is read in a stream. Memory: 16 bytes per cell of the grid, 64 KiB, and some 100 bytes for each of the file's
/// columns and rows; for x y z one bit per point besides, and two passes over the file; for .vti twice the array.
///
/// Throws InputError naming the file, the line where there is one, what was found and what is allowed: no such file,
/// another extension, text that is not as above, fewer or more numbers than announced, sizes that the file's bytes
/// cannot hold, numbers that are not finite, points twice, no data for a cell of the domain.
Field<double> read_ground(const GroundFile& file, const Grid& grid);

}  // namespace waterlight
