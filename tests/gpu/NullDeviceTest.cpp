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
        drawPlan(scene.upload, scene.finish(allBatches));
    }
    void drawPlan(const frame::SceneUpload& upload, const frame::FramePlan& plan) {
        ASSERT_TRUE(renderer_.upload(upload));
        Result<RenderTarget> target = RenderTarget::create(device_, 8, 8);
        ASSERT_TRUE(renderer_.render(plan, *target));
    }
    // Commands of one kind, their first argument.
    std::vector<std::size_t> of(Kind kind) const {
        std::vector<std::size_t> found;
        for (const NullDevice::Command& command : device_.commands())
            if (command.kind == kind)
                found.push_back(command.a);
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

    // An array in the ring, from where shaders read it as texels.
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

// What cull.comp finds of a slot: binary search among the runs of its group.
layout::RunPlace placeOf(std::uint32_t slot, std::span<const layout::SlotGroup> groups,
                         std::span<const layout::DrawRun> runs) {
    const layout::SlotGroup& group = groups[slot / layout::kSlotsPerGroup];
    layout::RunPlace place = group.place;
    std::uint32_t low = group.firstRun, high = group.lastRun;
    while (low < high) {
        const std::uint32_t middle = (low + high + 1) / 2;
        const bool isBehind = runs[middle].firstSlot <= slot;
        (isBehind ? low : high) = isBehind ? middle : middle - 1;
        place = isBehind ? runs[middle].place : place;
    }
    return place;
}

// One slot for every draw command, each with its piece and room for all its indices behind the one before.
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
    EXPECT_EQ(constants.flags & layout::kFrameKeepsTriangles, 0u);
    const auto groups = texels<layout::SlotGroup>(constants.firstSlotGroup, 1);
    const auto runs = texels<layout::DrawRun>(constants.firstRun, scene.plan.runs.size());
    const std::array<std::uint32_t, 4> pieces{0, 1, 4, 2}; // as batches follow; the sky's is the plan's first
    std::uint32_t next = placeOf(0, groups, runs).kept;
    for (std::uint32_t slot = 0; slot < 4; ++slot) {
        const layout::RunPlace place = placeOf(slot, groups, runs);
        const std::uint32_t piece = (slot + place.piece) & ~layout::kGated;
        EXPECT_EQ(piece, pieces[slot]);
        EXPECT_EQ(place.kept + (piece == 4 ? 0 : scene.upload.pieces[piece].indicesBefore), next);
        next += 6;
    }
    const std::size_t commands = device_.storage()[layout::kBindCommands].offset;
    EXPECT_EQ(of(Kind::DrawIndirect),
              (std::vector<std::size_t>{commands, commands + 2 * 20, commands + 3 * 20}))
        << "a batch's commands lie in its slots";
}

// Runs of one piece and of many, that begin, end and lie within groups, and cover several.
TEST_F(NullDeviceTest, theRunOfEverySlotIsFound) {
    constexpr std::uint32_t kWalls = 100;
    SceneBuilder scene;
    scene.root(0);
    std::vector<std::uint32_t> order; // of pieces: what does not follow the one before begins a run
    for (std::uint32_t i = 0; i < kWalls; ++i)
        scene.addWall('A', {-1, -1}, {1, 1}, 1);
    scene.finish();
    frame::FramePlan& plan = scene.plan;
    frame::Batch& batch = plan.batches[plan.stages[1].firstBatch];
    ASSERT_EQ(batch.draws, kWalls);
    plan.runs.clear();
    for (const std::uint32_t end : {1u, 2u, 3u, 16u, 31u, 32u, 33u, 80u, 81u, 82u, 100u}) {
        const auto first = static_cast<std::uint32_t>(order.size());
        const std::uint32_t piece = kWalls - end; // from the last backwards
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
        const layout::RunPlace place = placeOf(slot, groups, runs);
        EXPECT_EQ(((slot + place.piece) & ~layout::kGated) | (place.piece & layout::kGated), order[slot])
            << slot;
    }
}

TEST_F(NullDeviceTest, moreTrianglesThanMemoryIsKeptForAreAllDrawn) {
    SceneBuilder scene;
    scene.root(0);
    const std::array<glm::vec3, 4> quad{glm::vec3{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}};
    const std::uint32_t mesh = scene.addQuads('A', std::vector(layout::kTrianglesPerPiece / 2, quad));
    const auto keepsTriangles = [&] {
        const auto constants = arrayAt<layout::FrameConstants, 1>(layout::kBindFrame)[0].device;
        return (constants.flags & layout::kFrameKeepsTriangles) != 0;
    };
    draw(scene);
    EXPECT_FALSE(keepsTriangles());
    for (int i = 0; i < 4000; ++i)
        scene.drawAgain(mesh, frame::Program::Opaque, false);
    draw(scene);
    EXPECT_TRUE(keepsTriangles());
    EXPECT_EQ(of(Kind::Compute).size(), 1u) << "commands are made in any case";
    EXPECT_EQ(of(Kind::DrawIndirect).size(), 1u);
}

TEST_F(NullDeviceTest, occlusionTakesTwoPassesMore_andCanBeSwitchedOff) {
    SceneBuilder scene;
    scene.root(0);
    scene.addWall('A', {-1, -1}, {1, 1}, 1);
    draw(scene);
    EXPECT_EQ(of(Kind::Compute).size(), 3u) << "what comes first, tiles, what may be behind";
    const std::uint32_t calls = renderer_.report().glCalls;
    Result<RenderTarget> target = RenderTarget::create(device_, 8, 8);
    ASSERT_TRUE(renderer_.render(scene.finish(), *target, {.occlusion = false}));
    EXPECT_EQ(of(Kind::Compute).size(), 1u);
    EXPECT_EQ(renderer_.report().glCalls + 5, calls);
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
        EXPECT_NE(constants.flags & layout::kFrameKeepsTriangles, 0u);
        EXPECT_EQ(of(Kind::Compute).size(), 1u);
    }
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

TEST(NullDevice, buffersThatAreGoneTakeUpNoMemory) {
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
