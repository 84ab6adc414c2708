#include "gpu/device/NullDevice.h"

#include "SceneBuilder.h"
#include "frame/FrameView.h"
#include "gpu/Renderer.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace limen::gpu::test {
namespace {

using CommandKind = NullDevice::CommandKind;

class NullDeviceTest : public ::testing::Test {
protected:
    void draw(SceneBuilder& scene, bool allBatches = false) {
        drawPlan(scene.upload, scene.finish(allBatches));
    }
    void drawPlan(const frame::SceneUpload& upload, const frame::FramePlan& plan) {
        ASSERT_TRUE(renderer_.upload(upload));
        Result<RenderTarget> target = RenderTarget::create(device_, 8, 8);
        ASSERT_TRUE(renderer_.render(plan, *target));
    }
    // First parameters of the commands of one kind.
    std::vector<std::size_t> of(CommandKind kind) const {
        std::vector<std::size_t> found;
        for (const NullDevice::Command& command : device_.commands())
            if (command.kind == kind)
                found.push_back(command.a);
        return found;
    }
    // First elements of an array in the ring, by its binding.
    template <class T, std::size_t Count>
    std::array<T, Count> arrayAt(std::uint32_t binding) const {
        std::array<T, Count> values;
        std::memcpy(static_cast<void*>(values.data()),
                    device_.ring().subspan(device_.storage()[binding].offset).data(), sizeof(values));
        return values;
    }

    // An array in the ring that shaders read as texels.
    template <class T>
    std::vector<T> texels(std::uint32_t firstTexel, std::size_t count) const {
        std::vector<T> values(count);
        std::memcpy(static_cast<void*>(values.data()),
                    device_.ring().subspan(std::size_t{16} * firstTexel).data(), count * sizeof(T));
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
    scene.addWall('C', {-1, -1}, {1, 1}, 1, {.program = frame::Program::CutOut, .gated = true});
    draw(scene);
    EXPECT_THAT(of(CommandKind::Clear), ::testing::UnorderedElementsAre(0, 1, 2, 3));
    EXPECT_THAT(of(CommandKind::BeginStage), ::testing::ElementsAre(0, 1, 2, 3, 4));
    EXPECT_EQ(of(CommandKind::BeginPass), (std::vector<std::size_t>{static_cast<std::size_t>(Pass::Ownership),
                                                                    static_cast<std::size_t>(Pass::Solid)}));
    EXPECT_EQ(of(CommandKind::DrawIndirect).size(), 2u) << "one call per batch";
    EXPECT_EQ(of(CommandKind::DrawVertices).size(), 2u) << "ownership and plain sky";
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
    EXPECT_EQ(
        std::memcmp(at(layout::kBindFrame).data(), &scene.plan.constants, sizeof(layout::ViewConstants)), 0);
    const auto constants = arrayAt<layout::FrameConstants, 1>(layout::kBindFrame)[0].device;
    EXPECT_EQ(std::memcmp(device_.ring().subspan(std::size_t{16} * constants.firstVisit).data(),
                          scene.plan.visits.data(), 2 * sizeof(layout::Visit)),
              0)
        << "read as texels";
    EXPECT_EQ(std::memcmp(at(layout::kBindOwnership).data(), scene.plan.ownershipVertices.data(),
                          6 * sizeof(layout::OwnershipVertex)),
              0);
    for (const StorageRange& range : device_.storage()) {
        EXPECT_GT(range.size, 0u);
        EXPECT_EQ(range.offset % device_.capabilities().storageAlignment, 0u);
    }
}

// Same search as in cull.comp: binary search among the runs of the slot's group.
layout::RunOffsets offsetsOf(std::uint32_t slot, std::span<const layout::SlotGroup> groups,
                             std::span<const layout::DrawRun> runs) {
    const layout::SlotGroup& group = groups[slot / layout::kSlotsPerGroup];
    layout::RunOffsets offsets = group.offsets;
    std::uint32_t low = group.firstRun, high = group.lastRun;
    while (low < high) {
        const std::uint32_t middle = (low + high + 1) / 2;
        const bool isBehind = runs[middle].firstSlot <= slot;
        (isBehind ? low : high) = isBehind ? middle : middle - 1;
        offsets = isBehind ? runs[middle].offsets : offsets;
    }
    return offsets;
}

// Each draw command has a slot with its piece, and room for its indices after those of the slot before.
TEST_F(NullDeviceTest, everyIndexedDrawHasASlot) {
    SceneBuilder scene;
    scene.root(0);
    scene.addWall('A', {-1, -1}, {1, 1}, 1);
    scene.addWall('B', {-1, -1}, {1, 1}, 1);
    scene.addWall('C', {-1, -1}, {1, 1}, 1, {.program = frame::Program::Blended});
    scene.addSky({-1, -1}, {1, 1}, 1, 0, 0.5f);
    draw(scene);
    const auto constants = arrayAt<layout::FrameConstants, 1>(layout::kBindFrame)[0].device;
    EXPECT_EQ(constants.slotCount, 4u);
    EXPECT_EQ(constants.flags & layout::kFrameStaticIndices, 0u);
    const auto groups = texels<layout::SlotGroup>(constants.firstSlotGroup, 1);
    const auto runs = texels<layout::DrawRun>(constants.firstRun, scene.plan.runs.size());
    // in the order of the batches; the sky's is the plan's first
    const std::array<std::uint32_t, 4> pieces{0, 1, 4, 2};
    std::uint32_t next = offsetsOf(0, groups, runs).kept;
    for (std::uint32_t slot = 0; slot < 4; ++slot) {
        const layout::RunOffsets offsets = offsetsOf(slot, groups, runs);
        const std::uint32_t piece = (slot + offsets.piece) & ~layout::kGated;
        EXPECT_EQ(piece, pieces[slot]);
        EXPECT_EQ(offsets.kept + (piece == 4 ? 0 : scene.upload.pieces[piece].indicesBefore), next);
        next += 6;
    }
    const std::size_t commands = device_.storage()[layout::kBindCommands].offset;
    EXPECT_EQ(of(CommandKind::DrawIndirect),
              (std::vector<std::size_t>{commands, commands + 2 * 20, commands + 3 * 20}))
        << "a batch's commands lie in its slots";
}

// Runs of one piece and of many that begin, end or lie within groups, or cover several.
TEST_F(NullDeviceTest, theRunOfEverySlotIsFound) {
    constexpr std::uint32_t kWalls = 100;
    SceneBuilder scene;
    scene.root(0);
    std::vector<std::uint32_t> order; // of pieces: a gap in the order begins a run
    for (std::uint32_t i = 0; i < kWalls; ++i)
        scene.addWall('A', {-1, -1}, {1, 1}, 1);
    scene.finish();
    frame::FramePlan& plan = scene.plan;
    frame::Batch& batch = plan.batches[plan.stages[1].firstBatch];
    ASSERT_EQ(batch.draws, kWalls);
    plan.runs.clear();
    for (const std::uint32_t end : {1u, 2u, 3u, 16u, 31u, 32u, 33u, 80u, 81u, 82u, 100u}) {
        const auto first = static_cast<std::uint32_t>(order.size());
        const std::uint32_t piece = kWalls - end; // from the last to the first
        plan.runs.push_back({piece, end - first, 6 * piece, 6 * (end - first), first % 2 == 1});
        for (std::uint32_t i = 0; i < end - first; ++i)
            order.push_back((piece + i) | (first % 2 == 1 ? layout::kGated : 0));
    }
    batch.first = 0;
    batch.count = static_cast<std::uint32_t>(plan.runs.size());
    drawPlan(scene.upload, plan);
    const auto constants = arrayAt<layout::FrameConstants, 1>(layout::kBindFrame)[0].device;
    const auto groups = texels<layout::SlotGroup>(constants.firstSlotGroup, 7);
    const auto runs = texels<layout::DrawRun>(constants.firstRun, plan.runs.size());
    for (std::uint32_t slot = 0; slot < kWalls; ++slot) {
        const layout::RunOffsets offsets = offsetsOf(slot, groups, runs);
        EXPECT_EQ(((slot + offsets.piece) & ~layout::kGated) | (offsets.piece & layout::kGated), order[slot])
            << slot;
    }
}

TEST_F(NullDeviceTest, moreTrianglesThanTheCapacityAreDrawnUnculled) {
    SceneBuilder scene;
    scene.root(0);
    const std::array<glm::vec3, 4> quad{glm::vec3{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}};
    const std::uint32_t mesh = scene.addQuads('A', std::vector(layout::kTrianglesPerPiece / 2, quad));
    const auto keepsTriangles = [&] {
        const auto constants = arrayAt<layout::FrameConstants, 1>(layout::kBindFrame)[0].device;
        return (constants.flags & layout::kFrameStaticIndices) != 0;
    };
    draw(scene);
    EXPECT_FALSE(keepsTriangles());
    for (int i = 0; i < 4000; ++i)
        scene.drawAgain(mesh, frame::Program::Opaque, false);
    draw(scene);
    EXPECT_TRUE(keepsTriangles());
    EXPECT_EQ(of(CommandKind::Compute).size(), 1u) << "commands are written in any case";
    EXPECT_EQ(of(CommandKind::DrawIndirect).size(), 1u);
}

TEST_F(NullDeviceTest, occlusionTakesTwoPassesMore_andCanBeSwitchedOff) {
    SceneBuilder scene;
    scene.root(0);
    scene.addWall('A', {-1, -1}, {1, 1}, 1);
    draw(scene);
    std::vector<std::uint32_t> modes;
    for (const std::size_t program : of(CommandKind::Compute)) {
        const std::vector<UniformValue>& uniforms =
            device_.program(static_cast<ProgramHandle>(program)).uniforms;
        ASSERT_EQ(uniforms.size(), 1u);
        EXPECT_EQ(uniforms[0].location, layout::kUniformCullMode);
        modes.push_back(uniforms[0].value);
    }
    EXPECT_EQ(modes, (std::vector<std::uint32_t>{layout::kCullOccluders, layout::kCullOccludees,
                                                 layout::kCullOccludees}));
    const std::uint32_t calls = renderer_.report().glCalls;
    Result<RenderTarget> target = RenderTarget::create(device_, 8, 8);
    ASSERT_TRUE(renderer_.render(scene.finish(), *target, {.occlusion = false}));
    EXPECT_EQ(of(CommandKind::Compute).size(), 1u);
    EXPECT_EQ(renderer_.report().glCalls + 6, calls);
}

TEST_F(NullDeviceTest, depthTilesAreFoundWhenTheDepthSoFarMayBeRead) {
    SceneBuilder scene;
    scene.root(0);
    scene.addWall('A', {-1, -1}, {1, 1}, 1);
    draw(scene);
    std::vector<CommandKind> order;
    for (const NullDevice::Command& command : device_.commands())
        if (command.kind == CommandKind::Compute || command.kind == CommandKind::DrawIndirect ||
            command.kind == CommandKind::ReadDrawn)
            order.push_back(command.kind);
    ASSERT_GE(order.size(), 5u);
    order.resize(5);
    EXPECT_THAT(order,
                ::testing::ElementsAre(CommandKind::Compute, CommandKind::ReadDrawn, CommandKind::Compute,
                                       CommandKind::Compute, CommandKind::DrawIndirect));
}

TEST_F(NullDeviceTest, withoutExactOutlinesAllTrianglesAreDrawn) {
    SceneBuilder scene;
    scene.root(0);
    scene.addWall('A', {-1, -1}, {1, 1}, 1);
    for (const RendererOptions& options :
         {RendererOptions{.exactOutlines = false}, RendererOptions{.culling = Culling::None}}) {
        Renderer renderer(device_, options);
        ASSERT_TRUE(renderer.upload(scene.upload));
        Result<RenderTarget> target = RenderTarget::create(device_, 8, 8);
        ASSERT_TRUE(renderer.render(scene.finish(), *target));
        const auto constants = arrayAt<layout::FrameConstants, 1>(layout::kBindFrame)[0].device;
        EXPECT_NE(constants.flags & layout::kFrameStaticIndices, 0u);
        EXPECT_EQ(of(CommandKind::Compute).size(), 1u);
    }
}

TEST_F(NullDeviceTest, glCallsDoNotDependOnTheNumberOfDraws) {
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
        ASSERT_TRUE(renderer.upload(scene.upload)) << "and the replaced scene is released";
        EXPECT_GT(device.liveObjects(), 0u);
    }
    EXPECT_EQ(device.liveObjects(), 0u);
}

TEST_F(NullDeviceTest, invalidScene_isRefusedAndTheOldOneStays) {
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

TEST(StateTracker, theFirstClearColourIsThatOfAView_soFirstFramesMakeTheCallsOfLaterOnes) {
    EXPECT_EQ(StateTracker::kFirstClearColour, glm::vec4(frame::FrameView().voidColour, 1.0f));
}

TEST(NullDevice, destroyedBuffersUseNoMemory) {
    NullDevice device;
    const Result<BufferHandle> buffer = device.createBuffer("b", std::vector<std::byte>(1000));
    ASSERT_TRUE(buffer);
    EXPECT_EQ(device.buffer(*buffer).size(), 1000u);
    device.destroyBuffer(*buffer);
    EXPECT_EQ(device.buffer(*buffer).data(), nullptr);
    EXPECT_EQ(device.objects().bufferBytes, 0u);
}

} // namespace
} // namespace limen::gpu::test
