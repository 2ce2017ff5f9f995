// The formats of ground heights, each read into a mixer. See read_ground() for what they hold and refuse.
#pragma once

#include "sim/bathymetry_file.hpp"

namespace waterlight {

Field<double> read_ground_vti(const GroundFile& file, const Grid& grid);
Field<double> read_ground_esri(const GroundFile& file, const Grid& grid);
Field<double> read_ground_xyz(const GroundFile& file, const Grid& grid);

}  // namespace waterlight
