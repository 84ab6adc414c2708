#include "viewer/inspect/NameTags.h"

#include "support/SmallWorld.h"
#include "visibility/View.h"

#include <gtest/gtest.h>

namespace limen::viewer {
namespace {

constexpr world::SpaceIndex kCell = 1;

/// An eye in the cell that looks north, and one object 10 m ahead.
struct Scene {
    world::World world = test::smallWorld();
    world::DynamicState dynamics;
    visibility::VisibleSet visible = test::twoVisits();
    visibility::View eye;

    Scene() {
        eye.eye = {0, 0, 0};
        eye.forward = {0, 1, 0};
        eye.up = {0, 0, 1};
        add("Smith 70000001", 0x55, {0, 10, -1}, kCell);
    }
    void add(const std::string& name, std::uint64_t object, const Vec3& origin, world::SpaceIndex space) {
        world::PlacedObject placed;
        placed.name = name;
        placed.object = object;
        placed.origin = origin;
        placed.space = space;
        world.placed.push_back(placed);
        world::Instance part =
            test::instanceOf(world::InstanceKind::Dynamic, 1, space, object, 0x02000001, 100);
        part.bounds = {origin + Vec3(0, 0, 1), 0.5};
        part.firstMember = static_cast<std::uint32_t>(dynamics.members.size());
        part.memberCount = 1;
        dynamics.members.push_back(space);
        dynamics.instances.push_back(part);
    }
    [[nodiscard]] std::vector<NameTag> tags() const { return nameTags(world, dynamics, visible, eye); }
};

TEST(NameTags, standAboveTheObject) {
    const std::vector<NameTag> tags = Scene().tags();
    ASSERT_EQ(tags.size(), 1u);
    EXPECT_EQ(tags[0].name, "Smith") << "without the guid";
    EXPECT_NEAR(tags[0].at.x, 0.0, 1e-9);
    EXPECT_GT(tags[0].at.y, 0.0) << "the top is 0.5 m over the eye";
    EXPECT_NEAR(tags[0].distance, std::sqrt(101.0), 1e-9);
}

TEST(NameTags, areOfObjectsInViewAlone) {
    Scene scene;
    scene.add("behind 70000002", 0x56, {0, -10, 0}, kCell);
    scene.add("far 70000003", 0x57, {0, 41, 0}, kCell);
    EXPECT_EQ(scene.tags().size(), 1u);
    scene.dynamics.instances.clear();
    EXPECT_TRUE(scene.tags().empty()) << "an object that is not drawn";
}

TEST(NameTags, areHiddenByWalls) {
    Scene scene;
    // The outside is seen through the opening, whose region is a triangle in the upper right quarter.
    scene.add("left 70000002", 0x56, {-2, 10, 0}, world::kOutside);
    EXPECT_EQ(scene.tags().size(), 1u);
    scene.add("right 70000003", 0x57, {4, 10, 3}, world::kOutside);
    ASSERT_EQ(scene.tags().size(), 2u);
    EXPECT_EQ(scene.tags()[1].name, "right");
}

TEST(NameTags, nearestComesFirst) {
    Scene scene;
    scene.add("near 70000002", 0x56, {1, 5, 0}, kCell);
    ASSERT_EQ(scene.tags().size(), 2u);
    EXPECT_EQ(scene.tags()[0].name, "near");
}

} // namespace
} // namespace limen::viewer
