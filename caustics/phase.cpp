#include "caustics/phase.hpp"

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

PhaseTable::PhaseTable(const Phase& phase) : table_((octaves << node_bits) + 2), values_(table_.data()) {
    for (int i = 0; i < static_cast<int>(table_.size()); ++i) {
        const float sine2 = std::bit_cast<float>(first_bits + (i << (23 - node_bits)));
        table_[i] = static_cast<float>(evaluate(phase, std::min(1.0F, sine2)));
    }
}

}  // namespace waterlight
