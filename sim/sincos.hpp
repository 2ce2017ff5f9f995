// Sine and cosine together, for loops that must vectorise: calls of the C library do not.
#pragma once

#include <cmath>

namespace waterlight {

struct SinCos {
    float sine;
    float cosine;
};

/// For |x| up to 8000 rad, to 1.2e-7. Cody-Waite reduction to a quarter turn and the minimax polynomials of Cephes
/// (Moshier, sinf.c).
inline SinCos sincos_of(float x) {
    const float quarters = std::nearbyint(x * 0.63661977236758134f);
    const float r =
        ((x - quarters * 1.5703125f) - quarters * 4.837512969970703125e-4f) - quarters * 7.54978995489188e-8f;
    const float r2 = r * r;
    const float s = r + r * r2 * (-1.6666654611e-1f + r2 * (8.3321608736e-3f + r2 * -1.9515295891e-4f));
    const float c =
        1 - 0.5f * r2 + r2 * r2 * (4.166664568298827e-2f + r2 * (-1.388731625493765e-3f + r2 * 2.443315711809948e-5f));
    const int turn = static_cast<int>(quarters);
    const bool swap = (turn & 1) != 0;
    const float sine = swap ? c : s;
    const float cosine = swap ? s : c;
    return {(turn & 2) != 0 ? -sine : sine, ((turn + 1) & 2) != 0 ? -cosine : cosine};
}

}  // namespace waterlight
