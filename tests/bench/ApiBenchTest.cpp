// The costs of the C interface and of the Python module, compared with C++ within one run.
#include "ApiBench.h"

#include <cmath>
#include <gtest/gtest.h>

namespace limen::bench::test {
namespace {

const BenchRow* apiRowNamed(const std::vector<BenchRow>& rows, const std::string& name) {
    for (const BenchRow& row : rows)
        if (row.bench == name)
            return &row;
    return nullptr;
}

TEST(ApiBench, floodsThroughEachInterfaceGiveOneResultAtASmallCost) {
    const std::vector<BenchRow> rows = benchApi();
    const BenchRow* cpp = apiRowNamed(rows, "api/c++");
    ASSERT_NE(cpp, nullptr);
    EXPECT_GT(cpp->value, 0.3) << "the floods are no empty ones";
    for (const char* name : {"api/c/more", "api/python/more"}) {
        const BenchRow* more = apiRowNamed(rows, name);
        ASSERT_NE(more, nullptr) << name << ": " << rows.back().scene;
        if (std::isnan(more->value))
            GTEST_SKIP() << "there is no Python module";
        EXPECT_EQ(more->hash, cpp->hash) << name;
        EXPECT_LE(more->value, more->target) << name << ": ten times the figure of docs/performance.md";
    }
}

} // namespace
} // namespace limen::bench::test
