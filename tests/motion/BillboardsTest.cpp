#include "motion/Billboards.h"

#include "motion/DynamicStateBuilder.h"
#include "support/MovingHut.h"

#include <rapidcheck/gtest.h>

namespace limen::motion {
namespace {

using world::Facing;

void expectEqual(const Vec3& a, const Vec3& b) {
    EXPECT_NEAR(a.x, b.x, 1e-9);
    EXPECT_NEAR(a.y, b.y, 1e-9);
    EXPECT_NEAR(a.z, b.z, 1e-9);
}

const Mat3 kUpright(1.0);

TEST(Billboards, ofMode2FaceTheEyeWithoutRoll) {
    const Mat3 level = turnedToEye(Facing::Eye, kUpright, {1, 0, 0});
    expectEqual(level[0], {0, -1, 0});
    expectEqual(level[1], {1, 0, 0});
    expectEqual(level[2], {0, 0, 1});
    const Mat3 pitched = turnedToEye(Facing::Eye, kUpright, {0, 0.6, -0.8});
    expectEqual(pitched[0], {1, 0, 0});
    expectEqual(pitched[1], {0, 0.6, -0.8});
    expectEqual(pitched[2], {0, 0.8, 0.6});
}

TEST(Billboards, ofModes3To5KeepTheirAxis) {
    const Vec3 heading = glm::normalize(Vec3(3, 4, -12));
    // The axis that follows the heading: +z about x, +x about y, +y about z.
    const Mat3 aboutX = turnedToEye(Facing::AroundX, kUpright, heading);
    expectEqual(aboutX[0], {1, 0, 0});
    expectEqual(aboutX[2], glm::normalize(Vec3(0, 4, -12)));
    const Mat3 aboutY = turnedToEye(Facing::AroundY, kUpright, heading);
    expectEqual(aboutY[1], {0, 1, 0});
    expectEqual(aboutY[0], glm::normalize(Vec3(3, 0, -12)));
    const Mat3 aboutZ = turnedToEye(Facing::AroundZ, kUpright, heading);
    expectEqual(aboutZ[2], {0, 0, 1});
    expectEqual(aboutZ[1], {0.6, 0.8, 0});
    expectEqual(aboutZ[0], {0.8, -0.6, 0});
}

TEST(Billboards, turnAboutTheirOwnAxisNotTheWorlds) {
    const Mat3 lying = glm::mat3_cast(glm::angleAxis(glm::radians(90.0), Vec3(1, 0, 0))); // z becomes -y
    const Mat3 turned = turnedToEye(Facing::AroundZ, lying, {0.6, 0, 0.8});
    expectEqual(turned[2], lying[2]);
    expectEqual(turned[1], {0.6, 0, 0.8});
}

TEST(Billboards, withoutADirectionAcrossTheirAxisStayAsTheyAre) {
    const Mat3 turned = turnedToEye(Facing::AroundZ, kUpright, {0, 0, -1});
    for (int axis = 0; axis < 3; ++axis)
        expectEqual(turned[axis], kUpright[axis]);
    const Mat3 above = turnedToEye(Facing::Eye, kUpright, {0, 0, 1});
    EXPECT_NEAR(glm::determinant(above), 1.0, 1e-9);
    expectEqual(above[1], {0, 0, 1});
}

RC_GTEST_PROP(Billboards, keepScaleAndHandedness, ()) {
    const auto number = [](int least, int end) { return 0.01 * *rc::gen::inRange(least, end); };
    const Vec3 axis(number(-100, 100), number(-100, 100), number(101, 200));
    const Mat3 own = glm::mat3_cast(glm::angleAxis(number(0, 628), glm::normalize(axis)));
    const Vec3 scale(number(10, 500), number(10, 500), number(10, 500));
    const Vec3 heading = glm::normalize(Vec3(number(-100, 100), number(-100, 100), number(1, 100)));
    for (const Facing facing :
         {Facing::Fixed, Facing::Eye, Facing::AroundX, Facing::AroundY, Facing::AroundZ}) {
        const Mat3 turned =
            turnedToEye(facing, Mat3(own[0] * scale.x, own[1] * scale.y, own[2] * scale.z), heading);
        for (int i = 0; i < 3; ++i) {
            RC_ASSERT(std::abs(glm::length(turned[i]) - scale[i]) < 1e-9);
            RC_ASSERT(std::abs(glm::dot(turned[i], turned[(i + 1) % 3])) < 1e-9);
        }
        RC_ASSERT(std::abs(glm::determinant(turned) - scale.x * scale.y * scale.z) < 1e-6);
    }
}

// docs/ray-rule.md: the landcell's middle beyond 50 m, else the object beyond 5 m, else the part.
TEST(Billboards, faceOneDirectionForAnObjectUnlessTheEyeIsNear) {
    const Vec3 object(100.0 * 192.0 + 30.0, 200.0 * 192.0 + 40.0, 7.0), part = object + Vec3(2, 0, 5);
    const Vec3 middle(object.x + 6.0, object.y - 4.0, 0.0); // of landcell (1, 1)
    const auto heading = [&](const Vec3& eye, bool isOutdoors) {
        return ObjectView(eye, object, isOutdoors, {}).headingTo(part);
    };
    const Vec3 near = object + Vec3(0, -4, 0), off = object + Vec3(0, -6, 1);
    const Vec3 far(middle.x - 51.0, middle.y, 300.0), notQuite(middle.x - 49.0, middle.y, 30.0);
    expectEqual(heading(near, true), glm::normalize(part - near));
    expectEqual(heading(off, true), glm::normalize(object - off));
    expectEqual(heading(notQuite, true), glm::normalize(object - notQuite));
    expectEqual(heading(far, true), {1, 0, 0});
    expectEqual(heading(far, false), glm::normalize(object - far));
    expectEqual(heading(part, true), {0, 0, 1});
}

struct BillboardState : ::testing::Test {
    test::MovingHut hut;
    const std::uint32_t far = hut.source.addModel({{test::rectangle({-1, 0, 0}, {1, 0, 3}), "leaf", true}});
    const std::uint32_t tree =
        hut.source.addModel(test::boxExterior({-1, -1, 0}, {1, 1, 3}),
                            {{test::TestWorld::kItself, 1, 0, 0, 10}, {far, 5, 0, 0, 90}});

    [[nodiscard]] static std::vector<world::Instance> of(std::uint32_t record,
                                                         const world::DynamicState& state) {
        std::vector<world::Instance> found;
        std::copy_if(state.instances.begin(), state.instances.end(), std::back_inserter(found),
                     [&](const auto& i) { return i.record == record; });
        return found;
    }
    [[nodiscard]] world::DynamicState seenFrom(const world::World& world, const Vec3& eye) const {
        DynamicStateInput input;
        input.eye = hut.at(eye);
        input.allDoors = 1.0;
        world::DynamicState state;
        DynamicStateBuilder(world).build(input, state);
        return state;
    }
};

TEST_F(BillboardState, hasThoseInRangeTurnedAndWithTheirSpaces) {
    hut.source.addObject(tree, test::frameAt({108, 108, 2}, 30)); // in the middle of its landcell
    const world::World world = hut.load();
    ASSERT_EQ(world.billboards.size(), 1u);
    EXPECT_TRUE(of(far, seenFrom(world, {108, 48.5, 4})).empty()) << "59.5 m: the mesh";
    const world::DynamicState state = seenFrom(world, {108, 47.5, 4});
    const std::vector<world::Instance> cards = of(far, state);
    ASSERT_EQ(cards.size(), 1u);
    expectEqual(Vec3(cards[0].linear[1]), {0, 1, 0});
    EXPECT_EQ(cards[0].level, world::kNone);
    EXPECT_EQ(cards[0].placedIn, world::kOutside);
    const auto listed = state.instancesIn(world::kOutside);
    EXPECT_EQ(std::count_if(listed.begin(), listed.end(),
                            [&](world::InstanceIndex i) { return state.instances[i].record == far; }),
              1);
    EXPECT_NEAR(cards[0].bounds.radius, std::hypot(1.0, 1.5), 1e-5);
}

TEST_F(BillboardState, hasThoseOfLooseObjectsInTheSpacesThatTheyReach) {
    const std::uint32_t sign = hut.source.addModel({{test::rectangle({-1, 0, 0}, {1, 0, 1}), "sign", true}},
                                                   {{test::TestWorld::kItself, 2, 0, 0, 90}});
    hut.source.addStatic(hut.rear, sign, test::frameAt({14.3, 11.5, 2}, 0)); // by the inner door
    const world::World world = hut.load();
    EXPECT_TRUE(world.billboards.empty());
    const world::DynamicState state = seenFrom(world, {16, 12, 3});
    const std::vector<world::Instance> signs = of(sign, state);
    ASSERT_EQ(signs.size(), 1u);
    EXPECT_EQ(signs[0].memberCount, 2);
    EXPECT_GT(glm::dot(Vec3(signs[0].linear[1]), Vec3(-1, 0, 0)), 0.8) << "away from the eye";
}

} // namespace
} // namespace limen::motion
