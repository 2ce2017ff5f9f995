// Transforms of a whole plane between its slots (AxisBasis along x and y) and its cells.
#pragma once

#include <vector>

#include "sim/fft_axis.hpp"
#include "sim/fft_lines.hpp"
#include "sim/fft_plan.hpp"
#include "sim/field.hpp"

namespace waterlight {

/// The part of a plane that is wanted in space: nx by ny cells from column i0, row j0.
struct PlaneWindow {
    int i0 = 0;
    int j0 = 0;
    int nx = 0;
    int ny = 0;
};

/// Single precision, threads over batches of lines; each line is computed alike whatever the number of threads.
/// Planes are fields of pitch() by y.n values, of which x.n columns are in use.
class PlaneTransform {
  public:
    PlaneTransform(const AxisBasis& x, const AxisBasis& y);

    int pitch() const { return pitch_; }
    Field<float> make_plane() const { return {pitch_, y_.n}; }
    PlaneWindow everything() const { return {0, 0, x_.n, y_.n}; }

    /// Slots to y-space: the value, or the y-derivative. `from` may be `to`.
    void columns_to_space(const Field<float>& from, bool derivative, Field<float>& to);
    /// y-space to space: the value, or the x-derivative, of the window's cells into the window's nx by ny first cells
    /// of `to`, whose rows may be longer. `from` may be `to` when the window is everything.
    void rows_to_space(const Field<float>& from, bool derivative, const PlaneWindow& window, Field<float>& to);
    /// Space to slots, in place.
    void to_slots(Field<float>& plane);

  private:
    void prepare_scratch();
    float* scratch_of_thread();

    AxisBasis x_, y_;
    int pitch_;
    LinePacking x_value_, x_slope_, y_value_, y_slope_;
    LineFft row_, columns_;
    std::vector<Field<float>> scratch_;  ///< one per thread
};

}  // namespace waterlight
