#include "FieldHelp.h"
#include "TwoWays.h"
#include "gpu/GlFixture.h"

#include <set>

namespace limen::bench::test {
namespace {

/// Calls of a frame besides those of the groups: the wait for the ring's fence, viewport, shared bindings,
/// clears, three programs, the sky, and the new fence.
constexpr std::uint32_t kCallsBeside = 15;

class ClassicPathGlTest : public gpu::test::GlTest {
protected:
    /// Draws a view with both paths and compares the images. Returns the ids.
    static std::vector<std::uint32_t> expectSame(TwoWays& ways, const FieldView& view) {
        EXPECT_TRUE(ways.drawReal(view));
        const std::vector<std::uint32_t> ids = ways.target().readIds();
        const std::vector<std::uint8_t> colour = ways.target().readColour();
        const std::vector<float> depth = ways.target().readDepth();
        EXPECT_TRUE(ways.drawClassic(view));
        EXPECT_TRUE(ids == ways.target().readIds()) << "ids";
        EXPECT_TRUE(colour == ways.target().readColour()) << "colour";
        EXPECT_TRUE(depth == ways.target().readDepth()) << "depth";
        return ids;
    }
};

/// Number of boxes in an id image.
std::size_t boxesIn(const ObjectField& field, const std::vector<std::uint32_t>& ids) {
    const std::set<std::uint32_t> shown(ids.begin(), ids.end());
    std::size_t count = 0;
    for (const world::Instance& box : boxesOf(field)) {
        const auto first = shown.lower_bound(box.idBase);
        count += first != shown.end() && *first < box.idBase + 6 ? 1 : 0;
    }
    return count;
}

TEST_F(ClassicPathGlTest, showsTheSameAsTheRenderer) {
    for (const double share : {0.0, 0.1, 1.0}) {
        ObjectField field = makeField(smallField(share));
        const auto ways = TwoWays::create(*device_, field, 320, 180);
        ASSERT_TRUE(ways) << ways.error().message();
        std::set<std::vector<std::uint32_t>> pictures;
        const std::vector<FieldView> views = fieldViews(field, 4, 320, 180);
        for (std::uint32_t i = 0; i < views.size(); ++i) {
            field.moveTo(10 * i);
            const std::vector<std::uint32_t> ids = expectSame(**ways, views[i]);
            EXPECT_GT(boxesIn(field, ids), 20u);
            EXPECT_EQ(device_->glCalls(), kCallsBeside + 3 * (*ways)->classic().counts().draws);
            pictures.insert(ids);
        }
        EXPECT_EQ(pictures.size(), views.size()) << "each heading has a picture of its own";
    }
}

/// Gives every second instance a level of detail that ends 20 m from the eye, every third one that begins
/// there.
void addLevels(world::World& world, std::vector<world::Instance>& instances) {
    const std::uint16_t change = world::levelRangeLimit(20.0);
    for (std::size_t i = 0; i < instances.size(); ++i) {
        if (instances[i].kind == world::InstanceKind::Terrain || (i % 2 != 0 && i % 3 != 0))
            continue;
        world::Level level;
        (i % 2 == 0 ? level.range.upTo : level.range.from) = change;
        level.origin = world::localRangeSteps(Vec3(instances[i].origin));
        instances[i].level = static_cast<std::uint32_t>(world.levels.size());
        world.levels.push_back(level);
    }
}

TEST_F(ClassicPathGlTest, showsTheSameLevelsOfDetail) {
    for (const double share : {0.0, 1.0}) {
        ObjectField field = makeField(smallField(share));
        const auto whole = TwoWays::create(*device_, field, 320, 180);
        ASSERT_TRUE(whole) << whole.error().message();
        const FieldView view = fieldViews(field, 1, 320, 180).front();
        const std::size_t all = boxesIn(field, expectSame(**whole, view));
        addLevels(field.world, field.world.instances);
        addLevels(field.world, field.dynamics.instances);
        const auto ways = TwoWays::create(*device_, field, 320, 180);
        ASSERT_TRUE(ways) << ways.error().message();
        const std::size_t inRange = boxesIn(field, expectSame(**ways, view));
        EXPECT_LT(inRange, all);
        EXPECT_GT(inRange, 5u);
    }
}

TEST_F(ClassicPathGlTest, showsTheSameWhereADriverBeginsToDrawBeforeTheFrameIsWhole) {
    const ObjectField field = makeField({.objects = 10'000, .movingShare = 1.0});
    const auto ways = TwoWays::create(*device_, field, 320, 180);
    ASSERT_TRUE(ways) << ways.error().message();
    const std::vector<FieldView> views = fieldViews(field, 4, 320, 180);
    for (std::size_t i = 0; i < gpu::kFramesInFlight; ++i)
        ASSERT_TRUE((*ways)->drawReal(views[0])); // leaves other data in the memory of all frames in flight
    EXPECT_GT(boxesIn(field, expectSame(**ways, views[1])), 300u);
}

TEST_F(ClassicPathGlTest, whatMovesShowsElsewhere) {
    ObjectField field = makeField(smallField(1.0));
    const auto ways = TwoWays::create(*device_, field, 320, 180);
    ASSERT_TRUE(ways) << ways.error().message();
    const std::vector<FieldView> views = fieldViews(field, 4, 320, 180);
    const auto drawn = [&](std::uint32_t frame) {
        field.moveTo(frame);
        EXPECT_TRUE((*ways)->drawClassic(views[0]));
        return (*ways)->target().readIds();
    };
    const std::vector<std::uint32_t> before = drawn(0);
    EXPECT_NE(before, drawn(30));
    EXPECT_EQ(before, drawn(0));
}

} // namespace
} // namespace limen::bench::test
