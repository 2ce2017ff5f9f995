#include "app/floor_estimate.hpp"

#include <algorithm>

namespace waterlight {

void FloorEstimate::compute(const TruthSurface& surface, const Field<float>& irradiance) {
    constexpr double settled = 0.3;  // of the error found: it is then known to some 10 to 30 %
    constexpr int most = 32;
    TruthSettings settings;
    settings.floor = settings_;
    settings.tolerance = 1;  // one comparison of two solutions a call
    while (true) {
        settings.subsamples = subsamples_;
        settings.most_subsamples = 2 * subsamples_;
        const TruthMap better = truth_map(settings, surface);
        rmse_ = relative_rmse(irradiance, better.irradiance);
        if (better.error_estimate > settled * rmse_ && 4 * subsamples_ <= most) {
            subsamples_ *= 2;
            continue;
        }
        error_ = irradiance.clone();
        for (std::size_t n = 0; n < error_.size(); ++n)
            error_.data()[n] = static_cast<float>(irradiance.data()[n] - better.irradiance.data()[n]);
        // The next surface may need less.
        if (better.error_estimate < 0.25 * settled * rmse_) subsamples_ = std::max(1, subsamples_ / 2);
        return;
    }
}

}  // namespace waterlight
