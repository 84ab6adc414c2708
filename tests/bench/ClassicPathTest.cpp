#include "FieldHelp.h"
#include "TwoWays.h"

#include "gpu/device/NullDevice.h"

#include <cstring>
#include <gtest/gtest.h>
#include <set>

namespace limen::bench::test {
namespace {

using Kind = gpu::NullDevice::CommandKind;

/// Whether a sphere intersects the four sides of the frustum, from the offsets of its centre along right and
/// up.
bool isSeen(const visibility::View& view, const Sphere& sphere) {
    const Vec3 centre = sphere.centre - view.eye;
    const double ahead = glm::dot(centre, view.forward);
    const auto within = [&](const Vec3& axis, double tangent) {
        return std::abs(glm::dot(centre, axis)) <= ahead * tangent + sphere.radius * std::hypot(1.0, tangent);
    };
    return within(view.right, view.tanHalfX) && within(view.up, view.tanHalfY);
}

struct Expected {
    std::set<std::uint32_t> meshes;
    std::uint32_t objects = 0;
};
Expected expectedFrom(const ObjectField& field, const visibility::View& view) {
    Expected expected;
    const auto add = [&](const world::Instance& instance) {
        if (isSeen(view, instance.bounds)) {
            expected.meshes.insert(instance.mesh);
            ++expected.objects;
        }
    };
    for (const world::Instance& instance : field.world.instances)
        add(instance);
    for (const world::Instance& instance : field.dynamics.instances)
        add(instance);
    return expected;
}

/// The draw commands of the last frame.
std::vector<frame::gpu::DrawCommand> drawsOf(const gpu::NullDevice& device) {
    std::vector<frame::gpu::DrawCommand> draws;
    for (const gpu::NullDevice::Command& command : device.commands()) {
        if (command.kind == Kind::DrawIndirect) {
            EXPECT_EQ(command.b, 1u);
            std::memcpy(&draws.emplace_back(), device.ring().data() + command.a, sizeof draws.back());
        }
    }
    return draws;
}

TEST(ClassicPath, issuesOneDrawForEachVisibleGroup) {
    for (const double share : {0.0, 0.5, 1.0}) {
        const ObjectField field = makeField(smallField(share));
        gpu::NullDevice device;
        const auto ways = TwoWays::create(device, field, 320, 180);
        ASSERT_TRUE(ways) << ways.error().message();
        for (FieldView& view : fieldViews(field, 8, 320, 180)) {
            view.frame.view.tanHalfX = 0.2; // narrow, so that some groups are not visible
            ASSERT_TRUE((*ways)->drawClassic(view));
            const Expected expected = expectedFrom(field, view.frame.view);
            const std::vector<frame::gpu::DrawCommand> draws = drawsOf(device);
            std::uint32_t objects = 0;
            for (const frame::gpu::DrawCommand& draw : draws) {
                EXPECT_EQ(draw.baseInstance, objects);
                objects += draw.instanceCount;
            }
            EXPECT_EQ(draws.size(), expected.meshes.size());
            EXPECT_LT(draws.size(), field.world.meshes.size());
            EXPECT_EQ(objects, expected.objects);
            EXPECT_EQ((*ways)->classic().counts().draws, draws.size());
            EXPECT_EQ((*ways)->classic().counts().objects, objects);
        }
    }
}

TEST(ClassicPath, bindsTextureAndBuffersOnceForEachGroup) {
    const ObjectField field = makeField(smallField());
    gpu::NullDevice device;
    const auto ways = TwoWays::create(device, field, 320, 180);
    ASSERT_TRUE(ways) << ways.error().message();
    const std::vector<FieldView> views = fieldViews(field, 2, 320, 180);
    ASSERT_TRUE((*ways)->drawClassic(views[0]));
    const auto countOf = [&](Kind kind) {
        const auto commands = device.commands();
        return std::count_if(commands.begin(), commands.end(),
                             [&](const gpu::NullDevice::Command& command) { return command.kind == kind; });
    };
    EXPECT_GT(countOf(Kind::DrawIndirect), 10);
    EXPECT_EQ(countOf(Kind::BindTextures), countOf(Kind::DrawIndirect) + 1); // once for all other bindings
    EXPECT_EQ(countOf(Kind::BindStorage), countOf(Kind::DrawIndirect) + 1);
}

TEST(ClassicPath, givesBackWhatItTook) {
    const ObjectField field = makeField(smallField(0.5));
    gpu::NullDevice device;
    {
        const auto path = ClassicPath::create(device, field.world, field.dynamics);
        ASSERT_TRUE(path);
        EXPECT_GT(device.liveObjects(), 10u);
    }
    EXPECT_EQ(device.liveObjects(), 0u);
}

} // namespace
} // namespace limen::bench::test
