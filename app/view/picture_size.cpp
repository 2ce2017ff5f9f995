#include "app/view/picture_size.hpp"

#include <glm/common.hpp>

namespace waterlight {

namespace {

constexpr double longest_ms = 70, spare_ms = 35;  // at twice as long the interface is above ten pictures a second
constexpr int most = 8;
constexpr int settled_after = 2;  // pictures, after which a time counts: the first of a size allocates

}  // namespace

glm::ivec2 PictureSize::of(glm::ivec2 window, int wished) const {
    return glm::max(window / (wished > 0 ? wished : divisor_), glm::ivec2(1));
}

void PictureSize::learn(double draw_ms) {
    if (++since_change_ < settled_after) return;
    const int before = divisor_;
    const auto at_divisor = [&](int divisor) {
        const double finer = static_cast<double>(before) / divisor;
        return draw_ms * finer * finer;
    };
    while (divisor_ < most && at_divisor(divisor_) > longest_ms) ++divisor_;
    if (divisor_ == before && divisor_ > 1 && at_divisor(divisor_ - 1) < spare_ms) --divisor_;
    if (divisor_ != before) since_change_ = 0;
}

}  // namespace waterlight
