#include "core/SmallVec.h"

#include <rapidcheck.h>

#include <gtest/gtest.h>

namespace limen {
namespace {

using Short = SmallVec<std::uint16_t, 4>;

struct Point {
    float x = 0.0f, y = 0.0f;
    Point() = default;
    Point(float px, float py) : x(px), y(py) {}
    friend bool operator==(const Point&, const Point&) = default;
};

TEST(SmallVec, growsFromInsideToTheHeap) {
    Short v;
    EXPECT_TRUE(v.empty());
    for (std::uint16_t i = 0; i < 100; ++i) {
        v.push_back(i);
        EXPECT_EQ(v.size(), i + 1u);
        EXPECT_EQ(v.back(), i);
    }
    EXPECT_EQ(v.front(), 0);
    EXPECT_EQ(v[57], 57);
}

TEST(SmallVec, copiesAndMovesBothWays) {
    for (const std::size_t size : {0u, 3u, 4u, 5u, 50u}) {
        Short a(size, 7);
        Short copy = a;
        EXPECT_EQ(copy, a);
        Short moved = std::move(copy);
        EXPECT_EQ(moved, a);
        EXPECT_TRUE(copy.empty()); // NOLINT: the contract of a moved-from SmallVec
        for (const std::size_t other : {0u, 4u, 9u}) {
            Short b(other, 9);
            b = a;
            EXPECT_EQ(b, a);
            Short c(other, 9);
            c = std::move(b);
            EXPECT_EQ(c, a);
        }
    }
}

TEST(SmallVec, canPushItsOwnElement) {
    Short v{1, 2, 3, 4};
    v.push_back(v[0]);
    EXPECT_EQ(v, (Short{1, 2, 3, 4, 1}));
}

TEST(SmallVec, takesVectorsListsAndRanges) {
    const std::vector<std::uint16_t> source{1, 2, 3, 4, 5, 6};
    Short v = source;
    EXPECT_EQ(v.size(), 6u);
    v = {9, 8};
    EXPECT_EQ(v, (Short{9, 8}));
    v.assign(source.begin() + 1, source.begin() + 3);
    EXPECT_EQ(v, (Short{2, 3}));
    SmallVec<Point, 2> uvs{Point(0.0f, 1.0f)};
    uvs.push_back({2.0f, 3.0f});
    uvs.emplace_back(4.0f, 5.0f);
    EXPECT_EQ(uvs[2], Point(4.0f, 5.0f));
}

TEST(SmallVec, behavesLikeAVector) {
    const bool holds =
        rc::check("the same operations give the same content", [](const std::vector<std::uint16_t>& ops) {
            Short v;
            std::vector<std::uint16_t> model;
            for (const std::uint16_t op : ops) {
                switch (op % 5) {
                case 0:
                case 1:
                    v.push_back(op);
                    model.push_back(op);
                    break;
                case 2:
                    v.resize(op % 13, op);
                    model.resize(op % 13, op);
                    break;
                case 3: {
                    Short other = std::move(v);
                    v = other;
                    break;
                }
                default:
                    if (!model.empty()) {
                        v.pop_back();
                        model.pop_back();
                    }
                }
                RC_ASSERT(std::equal(v.begin(), v.end(), model.begin(), model.end()));
            }
        });
    EXPECT_TRUE(holds);
}

} // namespace
} // namespace limen
