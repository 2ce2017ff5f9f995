// A million steps of water that swings in a bowl, its shore with it.
#include <gtest/gtest.h>

#include <limits>

#include "tests/support/shallow_runs.hpp"

namespace waterlight::testing {
namespace {

template <class Real>
class ShallowLong : public ::testing::Test {};
using Precisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(ShallowLong, Precisions);

TYPED_TEST(ShallowLong, AMillionStepsKeepTheWater) {
    const ThackerPlanar bowl{.centre_m = {1.6, 0.05}};
    ShallowWaterSettings settings = settings_of(bowl, {32, 1, 0.1, 0.1, 0, 0}, periodic_along_y);
    // The water comes to rest in time, so it is stirred now and again.
    for (int n = 0; n < 50; ++n) settings.sources.push_back(Drop{{0.9, 0.05}, 0.5, n % 2 ? 0.1 : -0.1, 700.0 * n});
    const auto model = make_shallow_water<TypeParam>(settings);
    const double before = model->totals().volume_m3;
    double least_wet_m2 = 1e9, most_wet_m2 = 0;
    while (model->steps() < 1'000'000) {
        take_steps(*model, 200);
        ASSERT_GE(shallowest_m(*model, settings.grid), 0);
        least_wet_m2 = std::min(least_wet_m2, model->totals().inundated_m2);
        most_wet_m2 = std::max(most_wet_m2, model->totals().inundated_m2);
    }
    // Every step rounds every cell, at random.
    const double roundings = std::sqrt(1e6 * 32) * std::numeric_limits<TypeParam>::epsilon();
    EXPECT_NEAR(model->totals().volume_m3, before, roundings * 0.1 * settings.grid.cell_area_m2());
    EXPECT_GT(most_wet_m2, 1.2 * least_wet_m2);
}

}  // namespace
}  // namespace waterlight::testing
