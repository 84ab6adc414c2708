#include "BenchTable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>

namespace limen::bench {
namespace {

bench::BenchRow rowOf(double value, double target, bool lowerIsBetter) {
    bench::BenchRow row;
    row.bench = "flood/rooms";
    row.scene = "8x8";
    row.unit = "us";
    row.value = value;
    row.p95 = value * 2;
    row.target = target;
    row.hasTarget = true;
    row.lowerIsBetter = lowerIsBetter;
    row.against = {{"slow", 8.0}, {"fast", 2.0}};
    row.hash = 0xABC;
    return row;
}

TEST(BenchTable, metFollowsFromValueAndTarget) {
    EXPECT_TRUE(isMet(rowOf(2.0, 2.0, true)));
    EXPECT_FALSE(isMet(rowOf(2.1, 2.0, true)));
    EXPECT_TRUE(isMet(rowOf(300, 300, false)));
    EXPECT_FALSE(isMet(rowOf(299, 300, false)));
    EXPECT_FALSE(isMet(rowOf(std::numeric_limits<double>::quiet_NaN(), 2.0, true)));
    bench::BenchRow free = rowOf(5.0, 0.0, true);
    free.hasTarget = false;
    EXPECT_TRUE(isMet(free));
}

TEST(BenchTable, ratioComparesWithTheBestOfTheOthers) {
    EXPECT_DOUBLE_EQ(ratioOf(rowOf(1.0, 2.0, true)).value(), 2.0);
    EXPECT_DOUBLE_EQ(ratioOf(rowOf(16.0, 2.0, false)).value(), 2.0);
    bench::BenchRow alone = rowOf(1.0, 2.0, true);
    alone.against.clear();
    EXPECT_FALSE(ratioOf(alone));
    EXPECT_FALSE(ratioOf(rowOf(0.0, 2.0, true))); // an infinite ratio is not reported
}

TEST(BenchTable, jsonHasTheAgreedKeysInOrder) {
    EXPECT_EQ(
        benchJson(rowOf(1.0, 2.0, true)).dump(),
        R"({"bench":"flood/rooms","scene":"8x8","value":1.0,"p95":2.0,"unit":"us","against":{"slow":8.0,"fast":2.0},)"
        R"("ratio":2.0,"target":2.0,"met":true,"allocations":0,"hash":"0000000000000abc"})");
}

TEST(BenchTable, tableHasALineARowUnderItsHeading) {
    const std::vector<bench::BenchRow> rows{rowOf(1.0, 2.0, true), rowOf(3.0, 2.0, true)};
    const std::string table = benchTable(rows);
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 3);
    EXPECT_THAT(table, testing::AllOf(testing::HasSubstr("slow 8.000, fast 2.000"),
                                      testing::HasSubstr("2.00x"), testing::HasSubstr(" NO ")));
}

} // namespace
} // namespace limen::bench
