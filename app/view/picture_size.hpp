// How large a picture is drawn so that pictures come quickly.
#pragma once

#include <glm/vec2.hpp>

namespace waterlight {

/// Divides the sides of pictures by 1 to 8: by more while drawing takes longer than it may, by less again once
/// there is time to spare.
class PictureSize {
  public:
    /// Sides, at least 1, of a picture for a window of this size. `wished` > 0 is the divisor to take, 0 lets it
    /// choose.
    glm::ivec2 of(glm::ivec2 window, int wished) const;
    /// How long the last picture of its choice took.
    void learn(double draw_ms);

  private:
    int divisor_ = 1;
    int since_change_ = 0;
};

}  // namespace waterlight
