#include "card/CardRows.h"
#include "BenchTable.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace limen::bench::test {
namespace {

CardTimes timesOf(const std::string& way, PictureSize size, const std::vector<double>& frames) {
    CardTimes times{size.width, size.height, way, {}, 7};
    for (const double frame : frames) {
        CardTime time;
        time.frame = frame;
        time.stages.fill(frame / 10);
        times.places.push_back(time);
    }
    return times;
}

const BenchRow& rowNamed(const std::vector<BenchRow>& rows, const std::string& name) {
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const BenchRow& row) { return row.bench == name; });
    EXPECT_NE(found, rows.end()) << name;
    return *found;
}

TEST(CardRows, theSlowestPlaceHasTheTarget) {
    const std::vector<BenchRow> rows = cardRows({timesOf("fast/bindless", {2560, 1440}, {0.2, 0.6, 0.1})});
    const BenchRow& slowest = rowNamed(rows, "card/fast/bindless/2560x1440");
    EXPECT_DOUBLE_EQ(slowest.value, 0.6);
    EXPECT_TRUE(slowest.hasTarget);
    EXPECT_FALSE(isMet(slowest));
    EXPECT_EQ(slowest.hash, 7u);
    const BenchRow& mean = rowNamed(rows, "card/fast/bindless/2560x1440/mean");
    EXPECT_DOUBLE_EQ(mean.value, 0.3);
    EXPECT_FALSE(mean.hasTarget);
    EXPECT_DOUBLE_EQ(rowNamed(rows, "card/fast/bindless/2560x1440/solid").value, 0.03);
}

TEST(CardRows, otherWaysAndSizesHaveNoTarget) {
    for (const CardTimes& times :
         {timesOf("exact/bindless", {2560, 1440}, {9}), timesOf("fast/pages", {1280, 720}, {9})})
        for (const BenchRow& row : cardRows({times}))
            EXPECT_FALSE(row.hasTarget) << row.bench;
}

} // namespace
} // namespace limen::bench::test
