#include "export/picture.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "export/atomic_file.hpp"
#include "export/canvas.hpp"
#include "export/legend.hpp"

namespace waterlight {

namespace {

struct Size {
    int width = 0, height = 0;
    bool to_scale = true;
};

/// The axis whose cells are finer gets `enlarge` pixels a cell, the other as many as keep the picture true to scale.
Size picture_size(const Field<float>& field, glm::dvec2 pitch_m) {
    constexpr double longest_aspect = 8, least_longer_side = 480;
    const double finest = std::min(pitch_m.x, pitch_m.y);
    double width = field.nx() * pitch_m.x / finest, height = field.ny() * pitch_m.y / finest;
    const bool to_scale = std::max(width, height) <= longest_aspect * std::min(width, height);
    if (!to_scale) (width < height ? width : height) = std::max(width, height) / longest_aspect;
    const double enlarge = std::ceil(least_longer_side / std::max(width, height));
    return {static_cast<int>(std::lround(width * enlarge)), static_cast<int>(std::lround(height * enlarge)), to_scale};
}

class Painter {
  public:
    explicit Painter(ValueRange range)
        : range_(range),
          low_(static_cast<float>(range.low)),
          high_(static_cast<float>(range.high)),
          scale_(static_cast<float>(palette::map_steps / (range.high - range.low))) {}

    /// The palette step of each value of a row, and whether some lie beyond the range.
    void paint(const float* values, int count, std::uint8_t* to) {
        note_clipped(values, count);
        colour(range_.logarithmic ? spread(values, count) : values, count, to);
    }
    Clipped clipped() const { return clipped_; }

  private:
    /// Values of an even scale that have the positions of these on the logarithmic one.
    const float* spread(const float* values, int count) {
        spread_.resize(static_cast<std::size_t>(count));
        for (int i = 0; i < count; ++i)
            spread_[i] = low_ + (high_ - low_) * static_cast<float>(range_.position(std::max(values[i], 0.0F)));
        return spread_.data();
    }

    void colour(const float* __restrict values, int count, std::uint8_t* __restrict to) const {
        const float low = low_, scale = scale_, last = palette::map_steps - 1;
#pragma GCC ivdep
        for (int i = 0; i < count; ++i) {
            const float v = values[i];
            const float step = (v - low) * scale;
            const float clamped = step > 0 ? (step < last ? step : last) : 0;
            const int shown = v == v ? static_cast<int>(clamped) : palette::missing;
            to[i] = static_cast<std::uint8_t>(shown);
        }
    }

    void note_clipped(const float* __restrict values, int count) {
        float least = high_, greatest = low_;
#pragma omp simd reduction(min : least) reduction(max : greatest)
        for (int i = 0; i < count; ++i) {
            least = values[i] < least ? values[i] : least;
            greatest = values[i] > greatest ? values[i] : greatest;
        }
        clipped_.below |= least < low_;
        clipped_.above |= greatest > high_;
    }

    ValueRange range_;
    float low_, high_, scale_;
    std::vector<float> spread_;  ///< of a row
    Clipped clipped_;
};

/// The cell that each of `pixels` pixels along an axis shows.
std::vector<int> cells_of(int pixels, int cells) {
    std::vector<int> cell(static_cast<std::size_t>(pixels));
    for (int p = 0; p < pixels; ++p) cell[p] = static_cast<int>((2LL * p + 1) * cells / (2LL * pixels));
    return cell;
}

/// Copies palette steps of the field's cells to `area`, the row of largest y on top.
void enlarge(const std::vector<std::uint8_t>& steps, const Field<float>& field, Canvas& canvas, Rectangle area) {
    const std::vector<int> column = cells_of(area.width, field.nx()), row = cells_of(area.height, field.ny());
    for (int y = 0; y < area.height; ++y) {
        const std::uint8_t* from = steps.data() + static_cast<std::ptrdiff_t>(row[area.height - 1 - y]) * field.nx();
        std::uint8_t* to = canvas.row(area.top + y) + area.left;
        if (area.width == field.nx()) {
            std::copy_n(from, area.width, to);
        } else {
            for (int x = 0; x < area.width; ++x) to[x] = from[column[x]];
        }
    }
}

}  // namespace

IndexedImage draw_picture(const Field<float>& field, const PictureSettings& settings) {
    assert(!field.empty() && settings.range.low < settings.range.high);
    assert(settings.pitch_m.x > 0 && settings.pitch_m.y > 0);
    Painter painter(settings.range);
    std::vector<std::uint8_t> steps(field.size());
    for (int j = 0; j < field.ny(); ++j) {
        painter.paint(field.row(j), field.nx(), steps.data() + static_cast<std::ptrdiff_t>(j) * field.nx());
    }
    const Size size = picture_size(field, settings.pitch_m);
    if (!settings.legend) {
        Canvas canvas(size.width, size.height, settings.map, settings.missing);
        enlarge(steps, field, canvas, {0, 0, size.width, size.height});
        return canvas.take();
    }
    const bool has_length = size.to_scale && settings.length_bar;
    const double metres_per_pixel = has_length ? field.nx() * settings.pitch_m.x / size.width : 0;
    const Legend legend(settings, size.width, size.height, metres_per_pixel, painter.clipped());
    Canvas canvas(legend.canvas_width(), legend.canvas_height(), settings.map, settings.missing);
    legend.draw(canvas);
    enlarge(steps, field, canvas, legend.picture());
    return canvas.take();
}

void write_picture(const std::filesystem::path& path, const Field<float>& field, const PictureSettings& settings) {
    write_file(path, encode_png(draw_picture(field, settings)));
}

}  // namespace waterlight
