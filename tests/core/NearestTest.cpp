#include "core/Nearest.h"

#include <gtest/gtest.h>

namespace limen {
namespace {

using Names = std::vector<std::string>;

TEST(Nearest, theDistanceCountsInsertionsDeletionsReplacementsAndSwaps) {
    EXPECT_EQ(editDistance("", ""), 0u);
    EXPECT_EQ(editDistance("", "abc"), 3u);
    EXPECT_EQ(editDistance("shot", "shto"), 1u);
    EXPECT_EQ(editDistance("tour", "tours"), 1u);
    EXPECT_EQ(editDistance("probe", "prove"), 1u);
    EXPECT_EQ(editDistance("kitten", "sitting"), 3u);
}

TEST(Nearest, plainNamesIgnoreCaseSpacesAndHyphens) {
    EXPECT_EQ(plainName("Al-Arqas"), plainName("al arqas"));
    EXPECT_EQ(plainName("Qalaba'r"), "qalabar");
    EXPECT_NE(plainName("Lin"), plainName("Kara"));
}

TEST(Nearest, aMisspeltNameIsFoundFirst) {
    const Names verbs{"view", "shot", "tour", "probe", "walk", "check"};
    EXPECT_EQ(nearest("shto", verbs), Names{"shot"});
    EXPECT_EQ(nearest("chekc", verbs), Names{"check"});
    EXPECT_TRUE(nearest("xyzzy", verbs).empty());
    EXPECT_TRUE(nearest("", verbs).empty());
}

TEST(Nearest, aPartOfANameComesAfterMisspellings) {
    const Names places{"Cottage cellar", "cellar", "hill"};
    EXPECT_EQ(nearest("celar", places), Names{"cellar"});
    EXPECT_EQ(nearest("cellar", places), (Names{"cellar", "Cottage cellar"}));
    EXPECT_EQ(nearest("cellar", places, 1), Names{"cellar"});
}

TEST(Nearest, theQuestionJoinsTheNames) {
    EXPECT_EQ(didYouMean({}), "");
    EXPECT_EQ(didYouMean(Names{"a"}), " Did you mean 'a'?");
    EXPECT_EQ(didYouMean(Names{"a", "b", "c"}), " Did you mean 'a', 'b' or 'c'?");
}

} // namespace
} // namespace limen
