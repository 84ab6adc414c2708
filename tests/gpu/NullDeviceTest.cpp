#include "gpu/NullDevice.h"

#include "SceneBuilder.h"
#include "gpu/Renderer.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace limen::gpu::test {
namespace {

using Kind = NullDevice::Command::Kind;

class NullDeviceTest : public ::testing::Test {
protected:
    void draw(SceneBuilder& scene, bool allBatches = false) {
        ASSERT_TRUE(renderer_.upload(scene.upload));
        Result<RenderTarget> target = RenderTarget::create(device_, 8, 8);
        ASSERT_TRUE(renderer_.render(scene.finish(allBatches), *target));
    }
    // Commands of one kind, their first argument.
    std::vector<std::size_t> of(Kind kind) const {
        std::vector<std::size_t> found;
        for (const NullDevice::Command& command : device_.commands()) {
            if (command.kind == kind) {
                found.push_back(command.a);
            }
        }
        return found;
    }
    // The first of an array in the ring, by its binding.
    template <class T, std::size_t Count>
    std::array<T, Count> arrayAt(std::uint32_t binding) const {
        std::array<T, Count> values;
        std::memcpy(static_cast<void*>(values.data()),
                    device_.ring().subspan(device_.storage()[binding].offset).data(), sizeof(values));
        return values;
    }

    NullDevice device_;
    Renderer renderer_{device_};
};

TEST_F(NullDeviceTest, frameIsClearsThenStagesInOrder) {
    SceneBuilder scene;
    scene.root(0);
    scene.visitThrough({-1, -1}, {1, 1}, 1, 1, 0);
    scene.addWall('A', {-1, -1}, {1, 1}, 1);
    scene.addWall('B', {-1, -1}, {1, 1}, 1, {.gated = true});
    scene.addWall('C', {-1, -1}, {1, 1}, 1, {.gated = true});
    draw(scene);
    EXPECT_THAT(of(Kind::Clear), ::testing::UnorderedElementsAre(0, 1, 2, 3));
    EXPECT_THAT(of(Kind::BeginStage), ::testing::ElementsAre(0, 1, 2, 3, 4));
    EXPECT_EQ(of(Kind::BeginPass), (std::vector<std::size_t>{static_cast<std::size_t>(Pass::Ownership),
                                                             static_cast<std::size_t>(Pass::Solid)}));
    EXPECT_EQ(of(Kind::DrawIndirect).size(), 2u) << "one call per batch";
    EXPECT_EQ(of(Kind::DrawVertices).size(), 2u) << "ownership and plain sky";
    EXPECT_EQ(renderer_.report().stages[1].draws, 3u);
    EXPECT_EQ(renderer_.report().stages[1].batches, 2u);
}

TEST_F(NullDeviceTest, plansArraysLieInTheRingAtTheirBindings) {
    SceneBuilder scene;
    scene.root(3);
    scene.visitThrough({-1, -1}, {1, 1}, 1, 4, 0);
    scene.addWall('A', {-1, -1}, {1, 1}, 1, {.members = {{3, 0}}});
    draw(scene);
    const auto at = [&](std::uint32_t binding) {
        return device_.ring().subspan(device_.storage()[binding].offset);
    };
    EXPECT_EQ(std::memcmp(at(layout::kBindFrame).data(), &scene.plan.constants,
                          offsetof(layout::FrameConstants, viewport)),
              0)
        << "all but what the target adds";
    const auto constants = arrayAt<layout::FrameConstants, 1>(layout::kBindFrame)[0];
    EXPECT_EQ(std::memcmp(device_.ring().subspan(std::size_t{16} * constants.firstVisit).data(),
                          scene.plan.visits.data(), 2 * sizeof(layout::Visit)),
              0)
        << "read as texels";
    EXPECT_EQ(std::memcmp(at(layout::kBindOwnership).data(), scene.plan.ownershipVertices.data(),
                          6 * sizeof(layout::OwnershipVertex)),
              0);
    const std::size_t commands = of(Kind::DrawIndirect).front();
    EXPECT_EQ(std::memcmp(device_.ring().data() + commands, scene.plan.commands.data(),
                          sizeof(layout::DrawCommand)),
              0);
    for (const StorageRange& range : device_.storage()) {
        EXPECT_GT(range.size, 0u);
        EXPECT_EQ(range.offset % device_.capabilities().storageAlignment, 0u);
    }
}

// One task for every draw command of the frame, each with room for all its indices behind the one before.
TEST_F(NullDeviceTest, everyIndexedDrawIsCulled) {
    SceneBuilder scene;
    scene.root(0);
    scene.addWall('A', {-1, -1}, {1, 1}, 1);
    scene.addWall('B', {-1, -1}, {1, 1}, 1, {.program = frame::Program::Blended});
    scene.addSky({-1, -1}, {1, 1}, 1, 0, 0.5f);
    draw(scene);
    const auto compute = std::find_if(device_.commands().begin(), device_.commands().end(),
                                      [](const auto& command) { return command.kind == Kind::Compute; });
    ASSERT_NE(compute, device_.commands().end());
    ASSERT_EQ(compute->b, 3u);
    const auto tasks = arrayAt<layout::CullTask, 3>(layout::kBindCullTasks);
    std::uint32_t next = tasks[0].indices.z;
    for (const layout::CullTask& task : tasks) {
        const layout::DrawCommand& command = scene.plan.commands[task.drawing.x];
        EXPECT_EQ(glm::uvec3(task.indices), glm::uvec3(command.firstIndex, 2, next));
        EXPECT_EQ(task.drawing.z, command.baseInstance);
        next += 6;
    }
    EXPECT_EQ(std::count_if(tasks.begin(), tasks.end(),
                            [](const auto& t) { return t.indices.w == layout::kKeepsAll; }),
              1)
        << "the sky's";
}

TEST_F(NullDeviceTest, moreTrianglesThanMemoryIsKeptForAreDrawnAsPlanned) {
    SceneBuilder scene;
    scene.root(0);
    const std::array<glm::vec3, 4> quad{glm::vec3{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}};
    const std::uint32_t mesh = scene.addQuads('A', std::vector(layout::kTrianglesPerCommand / 2, quad));
    draw(scene);
    EXPECT_EQ(of(Kind::Compute).size(), 1u);
    for (int i = 0; i < 4000; ++i) {
        scene.drawAgain(mesh, frame::Program::Opaque, false);
    }
    draw(scene);
    EXPECT_TRUE(of(Kind::Compute).empty());
    EXPECT_EQ(of(Kind::DrawIndirect).size(), 1u);
}

TEST_F(NullDeviceTest, withoutExactOutlinesNothingIsCulled) {
    SceneBuilder scene;
    scene.root(0);
    scene.addWall('A', {-1, -1}, {1, 1}, 1);
    Renderer renderer(device_, {.exactOutlines = false});
    ASSERT_TRUE(renderer.upload(scene.upload));
    Result<RenderTarget> target = RenderTarget::create(device_, 8, 8);
    ASSERT_TRUE(renderer.render(scene.finish(), *target));
    EXPECT_TRUE(of(Kind::Compute).empty());
}

TEST_F(NullDeviceTest, glCallsDoNotGrowWithWhatIsDrawn) {
    std::vector<std::uint32_t> counts;
    for (const std::uint32_t walls : {1u, 2000u}) {
        SceneBuilder scene;
        scene.root(0);
        for (std::uint32_t i = 0; i < walls; ++i) {
            scene.visitThrough({-1, -1}, {1, 1}, 1, i, 0);
            scene.addWall('A', {-1, -1}, {1, 1}, 1, {.gated = true});
        }
        draw(scene, true);
        counts.push_back(renderer_.report().glCalls);
    }
    EXPECT_EQ(counts[0], counts[1]);
    EXPECT_LE(counts[0], 40u);
}

TEST_F(NullDeviceTest, destroyedRenderer_leavesNothingBehind) {
    NullDevice device;
    {
        Renderer renderer(device);
        SceneBuilder scene;
        scene.root(0);
        ASSERT_TRUE(renderer.upload(scene.upload));
        ASSERT_TRUE(renderer.upload(scene.upload)) << "and what it replaced goes, too";
        EXPECT_GT(device.liveObjects(), 0u);
    }
    EXPECT_EQ(device.liveObjects(), 0u);
}

TEST_F(NullDeviceTest, brokenScene_isRefusedAndTheOldOneStays) {
    SceneBuilder scene;
    scene.root(0);
    draw(scene);
    const std::size_t objects = device_.liveObjects();
    frame::SceneUpload broken = scene.upload;
    broken.materialRefs.push_back(99);
    EXPECT_FALSE(renderer_.upload(broken));
    EXPECT_EQ(device_.liveObjects(), objects);
    draw(scene);
}

} // namespace
} // namespace limen::gpu::test
