#include "FieldHelp.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace limen::bench::test {
namespace {

std::map<std::uint64_t, std::uint32_t> idsByObject(const ObjectField& field) {
    std::map<std::uint64_t, std::uint32_t> ids;
    for (const world::Instance& box : boxesOf(field))
        ids[box.object] = box.idBase;
    return ids;
}

TEST(ObjectField, hasTheObjectsAndGroupsAskedFor) {
    const ObjectField field = makeField(smallField());
    const std::vector<world::Instance> boxes = boxesOf(field);
    std::set<std::uint32_t> meshes;
    for (const world::Instance& box : boxes) {
        meshes.insert(box.mesh);
        EXPECT_EQ(field.world.meshes[box.mesh].ranges[0].indexCount, 36u);
    }
    EXPECT_EQ(boxes.size(), 200u);
    EXPECT_EQ(meshes.size(), 20u);
    EXPECT_TRUE(field.dynamics.instances.empty());
}

TEST(ObjectField, objectsHaveTheSameIdsWhetherTheyMoveOrNot) {
    const auto still = idsByObject(makeField(smallField(0.0)));
    const auto mixed = idsByObject(makeField(smallField(0.5)));
    EXPECT_EQ(still.size(), 200u);
    EXPECT_EQ(still, mixed);
    std::set<std::uint32_t> bases;
    for (const auto& [object, base] : still)
        bases.insert(base);
    EXPECT_EQ(bases.size(), 200u);
}

TEST(ObjectField, asManyMoveAsAskedFor) {
    EXPECT_EQ(makeField(smallField(1.0)).dynamics.instances.size(), 200u);
    const std::size_t half = makeField(smallField(0.5)).dynamics.instances.size();
    EXPECT_GT(half, 75u);
    EXPECT_LT(half, 125u);
    const std::size_t few = makeField({10'000, 1662, 400.0, 0.01}).dynamics.instances.size();
    EXPECT_GT(few, 75u);
    EXPECT_LT(few, 125u);
}

TEST(ObjectField, boxesNeverTouch_howeverTheyMove) {
    ObjectField field = makeField(smallField(0.5));
    for (const std::uint32_t frame : {0u, 7u, 50u}) {
        field.moveTo(frame);
        const std::vector<world::Instance> boxes = boxesOf(field);
        for (std::size_t a = 0; a < boxes.size(); ++a) {
            const Sphere& sphere = boxes[a].bounds;
            const double height = field.world.meshes[boxes[a].mesh].bounds.centre.z;
            EXPECT_GT(sphere.centre.z, height) << "above the ground";
            EXPECT_LT(sphere.centre.z + height, field.eye.z) << "the eye is in no box";
            for (std::size_t b = 0; b < a; ++b) {
                const Vec3 apart = sphere.centre - boxes[b].bounds.centre;
                // Half widths are at most 0.6 m.
                EXPECT_GT(std::hypot(apart.x, apart.y), 2.0 * std::hypot(0.6, 0.6) - 1e-6);
            }
        }
    }
}

TEST(ObjectField, whatMovesMovesALittle_withItsBounds) {
    ObjectField field = makeField(smallField(1.0));
    field.moveTo(0);
    const std::vector<world::Instance> before = field.dynamics.instances;
    field.moveTo(1);
    for (std::size_t i = 0; i < before.size(); ++i) {
        const world::Instance& after = field.dynamics.instances[i];
        const double moved = glm::length(after.bounds.centre - before[i].bounds.centre);
        EXPECT_GT(moved, 0.001);
        EXPECT_LT(moved, 0.1);
        EXPECT_NEAR(glm::length(after.origin - before[i].origin), moved, 1e-4);
    }
}

TEST(ObjectField, viewsSeeTheOutsideAlone) {
    const ObjectField field = makeField(smallField());
    const std::vector<FieldView> views = fieldViews(field, 4, 320, 180);
    ASSERT_EQ(views.size(), 4u);
    for (const FieldView& view : views) {
        ASSERT_EQ(view.visible.visits.size(), 1u);
        EXPECT_EQ(view.visible.visits[0].zone, world::kOutsideZone);
        ASSERT_EQ(view.visible.seen.size(), 1u);
    }
    EXPECT_NEAR(glm::dot(views[0].frame.view.forward, views[1].frame.view.forward), 0.0, 1e-12);
}

} // namespace
} // namespace limen::bench::test
