#include "core/NumberText.h"

#include <gtest/gtest.h>

namespace limen {
namespace {

TEST(NumberText, digitsAreInGroupsOfThree) {
    EXPECT_EQ(groupedText(0), "0");
    EXPECT_EQ(groupedText(999), "999");
    EXPECT_EQ(groupedText(1000), "1,000");
    EXPECT_EQ(groupedText(805348), "805,348");
    EXPECT_EQ(groupedText(18446744073709551615u), "18,446,744,073,709,551,615");
}

} // namespace
} // namespace limen
