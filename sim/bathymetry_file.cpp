#include "sim/bathymetry_file.hpp"

#include <fmt/format.h>

#include <cmath>

#include "sim/error.hpp"
#include "sim/ground_mixer.hpp"
#include "sim/ground_readers.hpp"
#include "sim/text_file.hpp"
#include "sim/vti_reader.hpp"

namespace waterlight {

Field<double> read_ground_vti(const GroundFile& file, const Grid& grid) {
    const VtiScalars<double> array = read_vti_double(file.path, file.array);
    const Grid& from = array.grid;
    GroundMixer mixer(file, {from.nx, from.ny, from.dx_m, from.dy_m, from.x_m(0), from.y_m(0)}, grid);
    for (int j = 0; j < from.ny; ++j) {
        for (int i = 0; i < from.nx; ++i) {
            const double number = array.values(i, j);
            if (std::isinf(number)) {
                throw InputError(
                    fmt::format("{}: array \"{}\" must hold finite numbers, or NaN for no data; found {} "
                                "at {}",
                                file.path.string(), file.array, number, mixer.place(i, j)));
            }
            if (!std::isnan(number)) mixer.add(i, j, number);
        }
    }
    return mixer.heights();
}

Field<double> read_ground(const GroundFile& file, const Grid& grid) {
    const std::string extension = lower_case(file.path.extension().string());
    if (extension == ".vti") return read_ground_vti(file, grid);
    if (extension == ".asc") return read_ground_esri(file, grid);
    for (const char* text : {".xyz", ".txt", ".csv", ".dat"}) {
        if (extension == text) return read_ground_xyz(file, grid);
    }
    throw InputError(
        fmt::format("{}: ground is read from .vti, .asc (ESRI ASCII grid), .xyz, .txt, .csv or .dat "
                    "(lines of x, y, z); found the extension \"{}\"",
                    file.path.string(), extension));
}

}  // namespace waterlight
