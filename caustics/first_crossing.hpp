// Where a function first changes sign along a way.
#pragma once

#include <cmath>

namespace waterlight {

/// A way from `from` to `to`, searched in equal steps and then to within 1e-9.
struct SearchedWay {
    double from = 0;
    double to = 1;
    int steps = 1;  ///< >= 1: of two zeros within one step none is found
};

/// The first place where f, positive before, is not above 0: `from` where it is not there, `to` where it stays above 0.
template <class Function>
double first_crossing(const SearchedWay& way, Function f) {
    double a = way.from, fa = f(a);
    if (fa <= 0) return a;
    double b = a, fb = fa;
    for (int k = 1; k <= way.steps && fb > 0; ++k) {
        a = b;
        fa = fb;
        b = way.from + (way.to - way.from) * k / way.steps;
        fb = f(b);
    }
    if (fb > 0) return way.to;
    // The Illinois method: regula falsi that halves the value of the end it keeps.
    constexpr double enough = 1e-9;
    for (int k = 0; k < 40 && std::abs(b - a) > enough && fb != 0; ++k) {
        const double c = b - fb * (b - a) / (fb - fa), fc = f(c);
        if (fc * fb < 0) {
            a = b;
            fa = fb;
        } else {
            fa *= 0.5;
        }
        b = c;
        fb = fc;
    }
    return b;
}

}  // namespace waterlight
