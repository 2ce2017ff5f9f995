// Means over rectangles by Gauss and Lobatto's rule of five points each way: exact for polynomials of degree 7 in x and
// in y, of eighth order. Its points reach the edges, so that halving a rectangle shows a jump wherever it is; Gauss and
// Legendre's rule does not see one near an edge.
#pragma once

#include <array>
#include <cstddef>

namespace waterlight {

struct Rectangle {
    double x0 = 0;
    double y0 = 0;
    double width = 1;
    double height = 1;
};

/// Sum is a default-constructed zero that takes weighted values: sum.add(weight, f(x, y)). The weights add up to 1.
template <class Sum, class F>
Sum lobatto_mean(const F& f, const Rectangle& box) {
    // Abramowitz & Stegun, table 25.6, on [0, 1]. The ends are a hair inside, for a jump on the edge itself is outside;
    // the errors of the two ends cancel.
    constexpr double hair = 1e-11;
    constexpr std::array<double, 5> node{hair, 0.17267316464601143, 0.5, 0.82732683535398857, 1 - hair};
    constexpr std::array<double, 5> weight{1.0 / 20, 49.0 / 180, 16.0 / 45, 49.0 / 180, 1.0 / 20};
    Sum sum;
    for (std::size_t j = 0; j < 5; ++j)
        for (std::size_t i = 0; i < 5; ++i)
            sum.add(weight[i] * weight[j], f(box.x0 + node[i] * box.width, box.y0 + node[j] * box.height));
    return sum;
}

}  // namespace waterlight
