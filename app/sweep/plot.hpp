// Time against error, as a picture.
#pragma once

#include "app/sweep/table.hpp"
#include "export/drawing.hpp"

namespace waterlight {

/// Every setting as a point on logarithmic axes, those of the front joined and numbered as in the table, the tolerance
/// as a dashed line and the cheapest within it ringed. Settings without a positive time and error are left out.
Drawing plot_of(const Table& table);

}  // namespace waterlight
