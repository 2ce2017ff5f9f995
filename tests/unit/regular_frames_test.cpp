// Which frames a movie has.
#include <gtest/gtest.h>

#include "app/moments.hpp"

namespace waterlight::test {
namespace {

TEST(RegularFrames, AreThoseOnTheBeat) {
    // Frames 0 to 5; a row of probes alone is none.
    const std::vector<Moment> moments{{0, true},   {0.1, true}, {0.15, true}, {0.18, false},
                                      {0.2, true}, {0.3, true}, {0.34, true}};
    EXPECT_EQ(regular_frames(moments, 0.1), (std::vector<int>{0, 1, 3, 4}));
}

TEST(RegularFrames, AreAllOfALongEvenRun) {
    std::vector<Moment> moments;
    for (int i = 0; i <= 100000; ++i) moments.push_back({i * 0.1, true});
    EXPECT_EQ(regular_frames(moments, 0.1).size(), moments.size()) << "rounding does not add up";
}

}  // namespace
}  // namespace waterlight::test
