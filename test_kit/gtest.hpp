// Assertions on fields for GoogleTest, which whoever includes this links.
#pragma once

#include <gtest/gtest.h>

#include "test_kit/fields.hpp"

namespace waterlight {

inline ::testing::AssertionResult field_near(const char* field_text, const char* expected_text, const char*,
                                             const Field<float>& field, const Field<double>& expected,
                                             double tolerance) {
    if (field.nx() != expected.nx() || field.ny() != expected.ny())
        return ::testing::AssertionFailure() << field_text << " has " << field.nx() << " x " << field.ny() << " cells, "
                                             << expected_text << " has " << expected.nx() << " x " << expected.ny();
    const FarthestCell most = farthest(field, expected);
    if (most.distance <= tolerance) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << field_text << " is " << most.value << " in cell (" << most.i << ", "
                                         << most.j << "), " << expected_text << " is " << most.expected << ": "
                                         << most.distance << " apart, which exceeds " << tolerance;
}

inline ::testing::AssertionResult field_near(const char* field_text, const char* expected_text,
                                             const char* tolerance_text, const Field<float>& field,
                                             const Field<float>& expected, double tolerance) {
    return field_near(field_text, expected_text, tolerance_text, field, widened(expected), tolerance);
}

inline ::testing::AssertionResult field_near(const char* field_text, const char* expected_text,
                                             const char* tolerance_text, const Field<float>& field, double expected,
                                             double tolerance) {
    Field<double> everywhere(field.nx(), field.ny());
    everywhere.fill(expected);
    return field_near(field_text, expected_text, tolerance_text, field, everywhere, tolerance);
}

}  // namespace waterlight

/// Every cell of `field` within `tolerance` of `expected`: a field of the same size, on(grid, formula), or one number.
/// The message names the cell that is farthest off.
#define EXPECT_FIELD_NEAR(field, expected, tolerance) \
    EXPECT_PRED_FORMAT3(::waterlight::field_near, field, expected, tolerance)
#define ASSERT_FIELD_NEAR(field, expected, tolerance) \
    ASSERT_PRED_FORMAT3(::waterlight::field_near, field, expected, tolerance)
