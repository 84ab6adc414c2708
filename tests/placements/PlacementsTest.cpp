#include "placements/Placements.h"

#include <gtest/gtest.h>

namespace {

using namespace limen::placements;

TEST(Placements, aTypeAndItsNameAreTheSame) {
    for (const int type : {1, 7, 10, 12, 19, 20, 25, 26, 0, 47, -3})
        EXPECT_EQ(parseType(typeName(type)), type) << typeName(type);
    EXPECT_EQ(typeName(19), "door");
    EXPECT_EQ(typeName(47), "type 47");
    EXPECT_EQ(parseType("47"), 47);
    EXPECT_EQ(parseType("doors"), std::nullopt);
    EXPECT_EQ(parseType(""), std::nullopt);
    EXPECT_EQ(parseType("type"), std::nullopt);
}

} // namespace
