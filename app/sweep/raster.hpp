// Fields of different settings made comparable.
#pragma once

#include <vector>

#include "app/sweep/settings.hpp"
#include "sim/surface.hpp"

namespace waterlight {

/// The finest raster whose every pixel is a whole number of pixels of every setting's map. {0, 0} where no setting has
/// a map. Throws InputError where it has fewer than 8 pixels along an axis and some map has more.
glm::ivec2 common_raster(const std::vector<Setting>& settings);

/// Means over the boxes of pixels that make up each of raster.x by raster.y.
Field<float> averaged(const Field<float>& map, glm::ivec2 raster);

/// The greatest count of cells along each axis, at most 1024: the cells at whose centres surfaces are compared.
glm::ivec2 common_points(const std::vector<Setting>& settings);

/// Elevation (m) of the smooth surface at the centres of points.x by points.y cells that cover its domain.
Field<float> elevations(const Surface& surface, glm::ivec2 points);

/// A relative RMSE over several fields.
class RelativeError {
  public:
    void add(const Field<float>& found, const Field<float>& expected);
    /// NaN where nothing was added or all that was expected is zero.
    double value() const;

  private:
    double difference_ = 0;
    double square_ = 0;
};

}  // namespace waterlight
