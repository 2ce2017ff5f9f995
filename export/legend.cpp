#include "export/legend.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "export/ticks.hpp"

namespace waterlight {

namespace {

/// Letters grow with the picture.
int letter_size(int width, int height) { return std::clamp(std::max(width, height) / 48, 14, 64); }

/// Hundredths of a second up to a quarter of an hour, then whole seconds.
std::string time_text(double time_s) {
    return std::abs(time_s) < 1000 ? fmt::format("t = {:.2f} s", time_s) : fmt::format("t = {:.0f} s", time_s);
}

}  // namespace

Legend::Legend(const PictureSettings& settings, int width, int height, double metres_per_pixel, Clipped clipped)
    : em_(letter_size(width, height)), line_(std::max(1, em_ / 14)), clipped_(clipped) {
    title_ = render_text(settings.quantity, em_ * 9 / 8, true);
    unit_ = render_text(settings.unit, em_);
    if (settings.time_s) time_ = render_text(time_text(*settings.time_s), em_);

    const int most_ticks = std::clamp(height / (3 * em_), 3, 9);
    int label_width = unit_.width;
    for (const Tick& tick : round_ticks(settings.range, most_ticks)) {
        labels_.push_back({render_text(tick.label, em_), settings.range.position(tick.value)});
        label_width = std::max(label_width, labels_.back().text.width);
    }
    if (metres_per_pixel > 0) {
        const Tick length = round_down(metres_per_pixel * width / 4);
        length_ = render_text(length.label + " m", em_);
        length_px_ = static_cast<int>(std::lround(length.value / metres_per_pixel));
    }

    const int title_line = 2 * em_;
    picture_ = {em_, em_ + title_line, width, height};
    bar_ = {picture_.right() + 5 * em_ / 4, picture_.top, em_ * 5 / 4, height};
    if (clipped_.above) bar_.top += bar_.width, bar_.height -= bar_.width;
    if (clipped_.below) bar_.height -= bar_.width;
    const int titles = em_ + title_.width + 2 * em_ + time_.width + em_ + unit_.width + em_;
    canvas_width_ = std::max(bar_.right() + em_ + label_width + em_, titles);
    canvas_height_ = picture_.bottom() + em_ + (length_px_ > 0 ? em_ * 3 / 2 : 0);
}

void Legend::draw(Canvas& canvas) const {
    canvas.frame(picture_, line_);
    const int above = picture_.top - em_ * 4 / 5;
    canvas.write(title_, picture_.left, above - title_.height);
    const int time_left = std::max(picture_.right() - time_.width, picture_.left + title_.width + 2 * em_);
    canvas.write(time_, time_left, above - time_.height);
    canvas.write(unit_, std::max(bar_.left, time_left + time_.width + em_), above - unit_.height);
    draw_colour_bar(canvas);
    if (length_px_ > 0) draw_length_bar(canvas);
}

void Legend::draw_colour_bar(Canvas& canvas) const {
    canvas.frame(bar_, line_);
    for (int y = 0; y < bar_.height; ++y) {
        const int step = (2 * (bar_.height - y) - 1) * palette::map_steps / (2 * bar_.height);
        canvas.fill({bar_.left, bar_.top + y, bar_.width, 1}, static_cast<std::uint8_t>(step));
    }
    if (clipped_.above) draw_point(canvas, true);
    if (clipped_.below) draw_point(canvas, false);
    for (const Label& label : labels_) {
        const int y = bar_.bottom() - static_cast<int>(std::lround(label.position * bar_.height));
        canvas.fill({bar_.right() + line_, y - line_ / 2, em_ / 3, line_}, palette::ink);
        canvas.write(label.text, bar_.right() + em_ * 2 / 3, y - label.text.height / 2);
    }
}

/// The colour of an end runs out in a triangle: there are values beyond it.
void Legend::draw_point(Canvas& canvas, bool up) const {
    const auto colour = static_cast<std::uint8_t>(up ? palette::map_steps - 1 : 0);
    const int height = bar_.width - line_;
    for (int k = 0; k < height; ++k) {
        const int inset = bar_.width * k / (2 * height);
        const int y = up ? bar_.top - line_ - 1 - k : bar_.bottom() + line_ + k;
        const Rectangle inner{bar_.left + inset, y, bar_.width - 2 * inset, 1};
        canvas.fill({inner.left - line_, y, inner.width + 2 * line_, 1}, palette::ink);
        canvas.fill(inner, colour);
    }
}

void Legend::draw_length_bar(Canvas& canvas) const {
    const int middle = picture_.bottom() + em_ * 5 / 4;
    const int tick = em_ / 3;
    canvas.fill({picture_.left, middle, length_px_, line_}, palette::ink);
    canvas.fill({picture_.left, middle - tick, line_, 2 * tick + line_}, palette::ink);
    canvas.fill({picture_.left + length_px_ - line_, middle - tick, line_, 2 * tick + line_}, palette::ink);
    canvas.write(length_, picture_.left + length_px_ + em_ / 2, middle - length_.height / 2);
}

}  // namespace waterlight
