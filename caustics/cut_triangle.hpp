// A triangle cut where numbers that are linear over it are below zero.
#pragma once

#include <array>
#include <cmath>
#include <glm/vec2.hpp>

namespace waterlight {

struct CutTriangle {
    static constexpr int most_corners = 5;  ///< after two cuts
    /// Places on the triangle are parts of the ways from its first corner to its second and third.
    static constexpr std::array corners{glm::dvec2{0, 0}, glm::dvec2{1, 0}, glm::dvec2{0, 1}};

    struct Corner {
        glm::dvec2 at{0, 0};
        std::array<double, 2> level{0, 0};  ///< the two numbers that cut
    };
    std::array<Corner, most_corners> corner;
    int count = 0;

    void add(const Corner& c) { corner[count++] = c; }

    /// The part where a number is not below zero; each number may cut once.
    CutTriangle where_positive(int number) const {
        CutTriangle kept;
        for (int k = 0; k < count; ++k) {
            const Corner &a = corner[k], &b = corner[k + 1 == count ? 0 : k + 1];
            const double here = a.level[number], next = b.level[number];
            if (here >= 0) kept.add(a);
            if ((here > 0 && next < 0) || (here < 0 && next > 0)) kept.add(between(a, b, here / (here - next)));
        }
        return kept;
    }

    /// Of the whole triangle's area.
    double share() const {
        return integral([](const Corner&) { return 1.0; });
    }

    /// The integral of a function of a corner, linear between them, over the whole triangle's area.
    template <class Function>
    double integral(Function f) const {
        double sum = 0;
        for (int k = 1; k + 1 < count; ++k) {
            const glm::dvec2 p = corner[k].at - corner[0].at, q = corner[k + 1].at - corner[0].at;
            sum += std::abs(p.x * q.y - p.y * q.x) * (f(corner[0]) + f(corner[k]) + f(corner[k + 1])) / 3;
        }
        return sum;
    }

  private:
    static Corner between(const Corner& a, const Corner& b, double part) {
        return {a.at + part * (b.at - a.at),
                {a.level[0] + part * (b.level[0] - a.level[0]), a.level[1] + part * (b.level[1] - a.level[1])}};
    }
};

}  // namespace waterlight
