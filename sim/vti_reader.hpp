// Reads fields from VTK image data and from .pvd series, whoever wrote them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/field.hpp"
#include "sim/grid.hpp"

namespace waterlight {

/// One scalar array of a .vti file. Point data becomes a grid whose cell centres are the points.
template <class Real>
struct VtiScalars {
    Grid grid;
    Field<Real> values;
    int layers = 1;                ///< along z, one after another along the rows of the values
    std::optional<double> time_s;  ///< the file's "TimeValue"
};
using VtiField = VtiScalars<float>;

/// Reads the scalar array `name`, float or double, of the cells or else the points of a flat, unrotated image (one cell
/// or one point along z, in any format of VTK's). Throws InputError that names the file and what is wrong with it: for
/// a missing array, the array wanted and those found. Prints nothing.
VtiField read_vti(const std::filesystem::path& path, const std::string& name);

/// The same array in double precision.
VtiScalars<double> read_vti_double(const std::filesystem::path& path, const std::string& name);

/// The same of an image that may have any number of layers, in one piece where it has several.
VtiScalars<double> read_vti_volume(const std::filesystem::path& path, const std::string& name);

/// One file of a series.
struct TimedFile {
    double time_s = 0;
    std::filesystem::path path;
};

/// The files of a .pvd collection in order of time; relative names are resolved against the collection's folder. Does
/// not open them. Throws InputError naming the file and what is wrong with it, also where it lists no file. Prints
/// nothing.
std::vector<TimedFile> read_pvd(const std::filesystem::path& path);

}  // namespace waterlight
