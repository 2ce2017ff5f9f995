// Files of ground heights, made up for a test.
#pragma once

#include <fmt/format.h>

#include <functional>

#include "sim/bathymetry_file.hpp"
#include "tests/support/damaged_files.hpp"

namespace waterlight::testing {

/// Heights at the cell centres of a grid.
using Heights = std::function<double(double x_m, double y_m)>;

inline Field<double> sampled(const Grid& grid, const Heights& height) {
    Field<double> field(grid.nx, grid.ny);
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) field(i, j) = height(grid.x_m(i), grid.y_m(j));
    }
    return field;
}

inline std::string esri_text(const Grid& grid, const Field<double>& values) {
    std::string text = fmt::format("ncols {}\nnrows {}\nxllcorner {}\nyllcorner {}\ncellsize {}\nNODATA_value -9999\n",
                                   grid.nx, grid.ny, grid.x0_m, grid.y0_m, grid.dx_m);
    for (int j = grid.ny - 1; j >= 0; --j) {
        for (int i = 0; i < grid.nx; ++i) text += fmt::format("{} ", values(i, j));
        text += '\n';
    }
    return text;
}

/// Columns from the west, each from the south.
inline std::string xyz_text(const Grid& grid, const Field<double>& values) {
    std::string text = "x(m) y(m) z(m)\n";
    for (int i = 0; i < grid.nx; ++i) {
        for (int j = 0; j < grid.ny; ++j) {
            text += fmt::format("{} {} {}\n", grid.x_m(i), grid.y_m(j), values(i, j));
        }
    }
    return text;
}

inline std::string vti_text(const Grid& grid, const Field<double>& values, const std::string& name = "bed") {
    std::string text = fmt::format(
        "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
        "<ImageData WholeExtent=\"0 {0} 0 {1} 0 0\" Origin=\"{2} {3} 0\" Spacing=\"{4} {5} 1\">\n"
        "<Piece Extent=\"0 {0} 0 {1} 0 0\"><CellData><DataArray type=\"Float64\" Name=\"{6}\" format=\"ascii\">\n",
        grid.nx, grid.ny, grid.x0_m, grid.y0_m, grid.dx_m, grid.dy_m, name);
    for (const double value : values.values()) text += fmt::format("{} ", value);
    return text + "\n</DataArray></CellData></Piece></ImageData></VTKFile>\n";
}

/// The same heights in each format; the extension tells it.
inline std::string ground_text(const std::string& extension, const Grid& grid, const Field<double>& values) {
    if (extension == ".vti") return vti_text(grid, values);
    return extension == ".asc" ? esri_text(grid, values) : xyz_text(grid, values);
}

/// `text` as a file, read with the options of `file`.
inline Field<double> read_text(const std::string& extension, const std::string& text, const Grid& grid,
                               GroundFile file = {}) {
    const TemporaryFolder folder;
    file.path = folder / ("bed" + extension);
    put_bytes(file.path, text);
    return read_ground(file, grid);
}

/// What reading it complains of, without the file's name.
inline std::string ground_complaint(const std::string& extension, const std::string& text, const Grid& grid,
                                    GroundFile file = {}) {
    const TemporaryFolder folder;
    file.path = folder / ("bed" + extension);
    put_bytes(file.path, text);
    const std::string whole = complaint_of(file.path, [&] { read_ground(file, grid); });
    return whole.empty() ? whole : whole.substr(file.path.string().size());
}

}  // namespace waterlight::testing
