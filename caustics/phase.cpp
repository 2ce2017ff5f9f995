#include "caustics/phase.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace waterlight {

namespace {

double evaluate(const Phase& phase, double sine2) {
    switch (phase.type) {
        case Phase::Type::fournier_forand:
            return f64::fournier_forand(phase.index, phase.slope, sine2);
        case Phase::Type::pure_water:
            return f64::pure_water(1 - 2 * sine2);
        case Phase::Type::henyey_greenstein:
            break;
    }
    return f64::henyey_greenstein(phase.g, 1 - 2 * sine2);
}

}  // namespace

PhaseTable::PhaseTable(const Phase& phase) {
    constexpr int last = std::bit_cast<std::int32_t>(1.0F) - f32::phase_first_bits;
    table_.resize((last >> f32::phase_node_shift) + 2);  // one more beside the node of 1
    for (int i = 0; i < static_cast<int>(table_.size()); ++i) {
        const float sine2 = std::bit_cast<float>(f32::phase_first_bits + (i << f32::phase_node_shift));
        table_[i] = static_cast<float>(evaluate(phase, std::min(1.0F, sine2)));
    }
    values_ = table_.data();
}

}  // namespace waterlight
