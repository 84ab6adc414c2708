#include "check/FinerRays.h"

#include <gtest/gtest.h>

namespace limen::check {
namespace {

/// Strips across the pixel, one above the other: the index of the strip that a ray meets.
reference::Answer strips(double y, const std::vector<double>& edges) {
    reference::Answer answer;
    answer.id =
        10 + static_cast<std::uint32_t>(std::upper_bound(edges.begin(), edges.end(), y) - edges.begin());
    return answer;
}

bool finds(std::uint32_t id, const std::vector<double>& edges) {
    return onFinerRays(
        3, 0, [&](double, double y) { return strips(y, edges); },
        [id](const reference::Answer& a) { return a.id == id; });
}

TEST(FinerRays, findAStripThatIsNarrowerThanAnyGrid) {
    EXPECT_TRUE(finds(11, {0.00011, 0.00011 + 1e-9}));
    EXPECT_FALSE(finds(13, {0.00011, 0.00011 + 1e-9}));
}

// As the upper edges of a door's planks, seen from their own height.
TEST(FinerRays, findEachOfSeveralStripsBetweenTwoRaysOfTheGrid) {
    const std::vector<double> edges{0.00011, 0.000113, 0.000118, 0.000119, 0.00014};
    for (std::uint32_t id = 10; id <= 15; ++id)
        EXPECT_TRUE(finds(id, edges)) << id;
    EXPECT_FALSE(finds(16, edges));
}

TEST(FinerRays, comeToAnEndWhereEveryRayMeetsSomethingElse) {
    std::uint32_t next = 100, asked = 0;
    const auto noise = [&](double, double) {
        reference::Answer answer;
        answer.id = next++;
        ++asked;
        return answer;
    };
    EXPECT_FALSE(onFinerRays(0, 0, noise, [](const reference::Answer& a) { return a.id == 7; }));
    EXPECT_LT(asked, 20'000'000u);
}

} // namespace
} // namespace limen::check
