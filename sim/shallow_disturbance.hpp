// Drops, rain and wavemakers in shallow water: what they raise they take from around, and never more than is there.
#pragma once

#include <vector>

#include "sim/shallow_rows.hpp"
#include "sim/shallow_water.hpp"

namespace waterlight {

class ShallowSources {
  public:
    explicit ShallowSources(const ShallowWaterSettings& settings);

    /// What happens in (from_s, to_s], or at 0 where both are 0: patches for disturb(), in order.
    std::vector<DropPatch> between(double from_s, double to_s) const;
    void set_rain(std::span<const Rain> rain) { replace_rain(sources_, rain); }

  private:
    struct Maker {
        Wavemaker maker;
        Field<double> inflow_m_s;
    };
    std::vector<Drop> drops_in(double from_s, double to_s) const;

    Grid grid_;
    Boundary boundary_;
    std::vector<Source> sources_;
    std::vector<Maker> makers_;
};

/// Adds `patch` (m), whose lower left value belongs to cell (i0, j0), to the surface: to wet cells only, digging no
/// deeper than the ground; then the larger of what is raised and what is dug is scaled down to the other, so that no
/// water is made or lost.
template <class Real>
void disturb(const DropPatch& patch, const ShallowStart<Real>& start, ShallowFields<Real>& fields);

extern template void disturb<float>(const DropPatch&, const ShallowStart<float>&, ShallowFields<float>&);
extern template void disturb<double>(const DropPatch&, const ShallowStart<double>&, ShallowFields<double>&);

}  // namespace waterlight
