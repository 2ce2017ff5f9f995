// What happens at the sides of the domain.
#pragma once

namespace waterlight {

/// periodic: the surface repeats; wall: waves reflect, beyond it there is neither water nor light;
/// absorbing: waves leave, beyond it the water is still.
enum class Side { periodic, wall, absorbing };

/// Both x sides and both y sides.
struct Boundary {
    Side x = Side::periodic;
    Side y = Side::periodic;
    bool operator==(const Boundary&) const = default;
};

}  // namespace waterlight
