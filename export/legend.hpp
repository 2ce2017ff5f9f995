// What stands around a picture: title and time above, colour bar to the right, bar of known length below.
#pragma once

#include "export/canvas.hpp"
#include "export/picture.hpp"

namespace waterlight {

/// Whether some values lie beyond the ends of the colour bar.
struct Clipped {
    bool below = false;
    bool above = false;
};

/// Places and texts of a legend, in pixels of the canvas.
class Legend {
  public:
    /// For a picture of `width` x `height` pixels.
    Legend(const PictureSettings& settings, int width, int height, double metres_per_pixel, Clipped clipped);

    int canvas_width() const { return canvas_width_; }
    int canvas_height() const { return canvas_height_; }
    Rectangle picture() const { return picture_; }

    void draw(Canvas& canvas) const;

  private:
    struct Label {
        TextBlock text;
        double position = 0;  ///< along the colour bar, 0 at its lower end
    };
    void draw_colour_bar(Canvas& canvas) const;
    void draw_point(Canvas& canvas, bool up) const;
    void draw_length_bar(Canvas& canvas) const;

    int em_;
    int line_;
    Clipped clipped_;
    TextBlock title_, time_, unit_, length_;
    int length_px_ = 0;
    std::vector<Label> labels_;
    Rectangle picture_, bar_;
    int canvas_width_ = 0, canvas_height_ = 0;
};

}  // namespace waterlight
