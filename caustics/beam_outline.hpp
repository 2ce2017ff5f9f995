// Where a beam shows in a picture.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "caustics/camera.hpp"

namespace waterlight {

/// Rows from `low` to `high` of a picture's column.
struct PixelSpan {
    float low = 1;
    float high = 0;
};

/// The convex outline of a few points as the camera sees them. A beam lies within that of its six corners, for its
/// sides join points of its edges, which are straight.
class BeamOutline {
  public:
    /// Points relative to the camera, at most 8; what is behind the camera is cut off.
    BeamOutline(const Camera::Rays& rays, std::span<const glm::vec3> points) {
        const glm::vec3 forward(rays.forward);
        const glm::vec3 right(rays.right), up(rays.up), corner(rays.corner);
        const float per_right = 1 / glm::dot(right, right), per_up = 1 / glm::dot(up, up);
        const auto project = [&](glm::vec3 p, float ahead) {
            const glm::vec3 away = p / ahead - corner;
            add({glm::dot(away, right) * per_right, glm::dot(away, up) * per_up});
        };
        constexpr float nearest_m = 1e-3F;
        std::array<float, 8> ahead{};
        for (std::size_t i = 0; i < points.size(); ++i) {
            ahead[i] = glm::dot(points[i], forward);
            if (ahead[i] >= nearest_m) project(points[i], ahead[i]);
        }
        const bool cut = count_ < static_cast<int>(points.size());
        for (std::size_t i = 0; cut && i < points.size(); ++i)
            for (std::size_t k = 0; k < points.size(); ++k)
                if (ahead[i] >= nearest_m && ahead[k] < nearest_m)
                    project(points[i] + (points[k] - points[i]) * ((ahead[i] - nearest_m) / (ahead[i] - ahead[k])),
                            nearest_m);
        enclose();
    }

    bool empty() const { return count_ == 0; }
    /// Bounds, a hair wider than the outline, for rounding.
    float left() const { return corner_[0].x - slack; }
    float right() const { return corner_[count_ - 1].x + slack; }
    float bottom() const { return bottom_ - slack; }
    float top() const { return top_ + slack; }

    /// The rows that the outline covers on the vertical line through `column`.
    PixelSpan rows(float column) const {
        return {bound(lower_, lower_count_, column) - slack, bound(upper_, upper_count_, column) + slack};
    }

  private:
    static constexpr int most = 20;  // some of eight points, and the cuts from them to the others
    static constexpr float slack = 0.01F;

    void add(glm::vec2 p) { corner_[count_++] = p; }

    /// Sorts by column and keeps the lower and the upper half of the convex hull (Andrew's monotone chain).
    void enclose() {
        if (count_ == 0) return;
        std::sort(corner_.begin(), corner_.begin() + count_, [](glm::vec2 a, glm::vec2 b) { return a.x < b.x; });
        bottom_ = top_ = corner_[0].y;
        for (int i = 0; i < count_; ++i) {
            bottom_ = std::min(bottom_, corner_[i].y);
            top_ = std::max(top_, corner_[i].y);
            extend(lower_, lower_count_, corner_[i], 1);
            extend(upper_, upper_count_, corner_[i], -1);
        }
    }

    using Chain = std::array<glm::vec2, most>;

    static void extend(Chain& chain, int& count, glm::vec2 p, float turn) {
        while (count >= 2) {
            const glm::vec2 a = chain[count - 1] - chain[count - 2], b = p - chain[count - 2];
            if (turn * (a.x * b.y - a.y * b.x) > 0) break;
            --count;
        }
        // Of points above each other the chain keeps the outer.
        if (count == 1 && chain[0].x == p.x) {
            if (turn * (p.y - chain[0].y) < 0) chain[0] = p;
            return;
        }
        chain[count++] = p;
    }

    static float bound(const Chain& chain, int count, float x) {
        int k = 1;
        while (k < count - 1 && chain[k].x < x) ++k;
        if (count == 1) return chain[0].y;
        const glm::vec2 a = chain[k - 1], b = chain[k];
        const float width = b.x - a.x;
        return width > 0 ? a.y + (b.y - a.y) * std::clamp((x - a.x) / width, 0.0F, 1.0F) : a.y;
    }

    Chain corner_, lower_, upper_;
    int count_ = 0, lower_count_ = 0, upper_count_ = 0;
    float bottom_ = 0, top_ = 0;
};

/// Whether an outline may hold the centre of any pixel.
inline bool in_frame(const BeamOutline& o, glm::ivec2 size) {
    return !o.empty() && o.right() >= 0 && o.left() <= static_cast<float>(size.x - 1) && o.top() >= 0 &&
           o.bottom() <= static_cast<float>(size.y - 1);
}

}  // namespace waterlight
