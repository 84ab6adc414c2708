// Sliced uploads beside a scene that is drawn. The device ends up with the same content as after one upload
// at once. Common content is shared. No object of the old scene is released too early or never.
#include "SceneBuilder.h"
#include "gpu/Renderer.h"
#include "gpu/device/CheckedDevice.h"
#include "gpu/device/NullDevice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace limen::gpu::test {
namespace {

/// Records the content of textures and buffers, and the bytes moved by each step.
class WritingDevice final : public ForwardingDevice {
public:
    using ForwardingDevice::ForwardingDevice;
    using Level = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>; ///< texture, layer, level

    [[nodiscard]] Result<BufferHandle> reserveBuffer(std::string_view label, std::size_t bytes) override {
        const Result<BufferHandle> buffer = device().reserveBuffer(label, bytes);
        ++reserved;
        fill(label, *buffer, bytes);
        return buffer;
    }
    void refillBuffer(std::string_view label, BufferHandle buffer) override {
        device().refillBuffer(label, buffer);
        fill(label, buffer, sizes[labels[buffer]]);
    }
    void writeBuffer(BufferHandle buffer, std::size_t offset, std::span<const std::byte> bytes) override {
        device().writeBuffer(buffer, offset, bytes);
        std::vector<std::byte>& array = arrays[labels[buffer]];
        EXPECT_EQ(array.size(), offset);
        array.insert(array.end(), bytes.begin(), bytes.end());
        moved += bytes.size();
    }
    [[nodiscard]] Result<TextureHandle> createTexture(std::string_view label,
                                                      const TextureShape& shape) override {
        ++textures;
        return device().createTexture(label, shape);
    }
    void writeTexture(TextureHandle texture, const TextureRows& rows,
                      std::span<const std::uint8_t> rgba) override {
        device().writeTexture(texture, rows, rgba);
        auto& level = levels[{static_cast<std::uint32_t>(texture), rows.layer, rows.level}];
        EXPECT_EQ(level.size(), std::size_t{rows.first} * rows.width * 4);
        level.insert(level.end(), rgba.begin(), rgba.end());
        moved += rgba.size();
    }
    [[nodiscard]] Result<ProgramHandle> createProgram(const ProgramSource& source) override {
        ++programs;
        return device().createProgram(source);
    }
    /// Texels of all textures, in order of creation.
    [[nodiscard]] std::vector<std::vector<std::uint8_t>> texels() const {
        std::vector<std::vector<std::uint8_t>> all;
        for (const auto& [place, level] : levels)
            all.push_back(level);
        return all;
    }

    void fill(std::string_view label, BufferHandle buffer, std::size_t bytes) {
        labels[buffer] = label;
        sizes[std::string(label)] = bytes;
        arrays[std::string(label)].clear();
    }

    std::map<BufferHandle, std::string> labels;
    std::map<std::string, std::size_t> sizes;
    std::map<std::string, std::vector<std::byte>> arrays;
    std::map<Level, std::vector<std::uint8_t>> levels;
    std::size_t moved = 0, textures = 0, programs = 0, reserved = 0;
};

Capabilities capabilitiesOf(bool bindless) {
    Capabilities capabilities = NullDevice::defaultCapabilities();
    capabilities.bindless = bindless;
    return capabilities;
}

/// Walls with pictures; equal keys mean equal pictures in every scene.
class Scene {
public:
    Scene(std::initializer_list<std::uint64_t> keys, std::uint32_t walls) {
        builder.root(0);
        for (const std::uint64_t key : keys) {
            const std::uint32_t side = key % 2 == 0 ? 32 : 16;
            std::vector<std::uint8_t> texels(std::size_t{side} * side * 4);
            for (std::size_t i = 0; i < texels.size(); ++i)
                texels[i] = static_cast<std::uint8_t>(i * (key + 7));
            const std::uint32_t texture = builder.addTexture(side, side, std::move(texels));
            builder.upload.textures.back().contentKey = key;
            material_ = builder.addMaterial({1, 1, 1, 1}, texture);
        }
        for (std::uint32_t i = 0; i < walls; ++i)
            builder.addWall('A' + i, {-1, -1}, {1, 1}, 1.0f + static_cast<float>(i), {.material = material_});
        builder.finish();
    }
    SceneBuilder builder;

private:
    std::uint32_t material_ = 0;
};

class StagedScenes : public ::testing::TestWithParam<bool> {
protected:
    void upload(const Scene& scene) { ASSERT_TRUE(renderer_.upload(scene.builder.upload)); }
    void begin(const Scene& scene) {
        Result<StagedScene> staged =
            stageScene(scene.builder.upload, renderer_.options(), device_.capabilities(), renderer_.state());
        ASSERT_TRUE(staged);
        ASSERT_TRUE(renderer_.begin(std::move(*staged)));
    }
    /// Yields the number of slices.
    int advanceToTheEnd(std::size_t bytes) {
        for (int slices = 1; slices < 100'000; ++slices) {
            const std::size_t before = device_.moved;
            const Result<bool> advanced = renderer_.advance(bytes);
            EXPECT_TRUE(advanced) << (advanced ? "" : advanced.error().message());
            EXPECT_LE(device_.moved - before, bytes + kSlack);
            if (!advanced || *advanced)
                return slices;
        }
        ADD_FAILURE() << "the upload does not end";
        return 0;
    }
    void draw(const Scene& scene) {
        ASSERT_TRUE(renderer_.render(scene.builder.plan, target_));
        for (const std::string& fault : checked_.faults())
            ADD_FAILURE() << fault;
    }

    static constexpr std::size_t kSlack = 512; ///< a row of texels, and the padding of short arrays
    NullDevice null_{capabilitiesOf(GetParam())};
    CheckedDevice checked_{null_};
    WritingDevice device_{checked_};
    RenderTarget target_ = *RenderTarget::create(device_, 8, 8);
    Renderer renderer_{device_};
};

TEST_P(StagedScenes, slicedUploadEqualsUploadAtOnce) {
    const Scene scene({1, 2, 3, 4, 5}, 40);
    NullDevice null(capabilitiesOf(GetParam()));
    WritingDevice atOnce(null);
    Renderer other(atOnce);
    ASSERT_TRUE(other.upload(scene.builder.upload));
    begin(scene);
    EXPECT_GT(advanceToTheEnd(700), 20);
    renderer_.swap();
    EXPECT_EQ(device_.arrays, atOnce.arrays);
    EXPECT_EQ(device_.texels(), atOnce.texels());
    for (const auto& [label, bytes] : device_.arrays)
        EXPECT_LE(bytes.size(), device_.sizes[label]) << label;
    draw(scene);
}

TEST_P(StagedScenes, theOldSceneIsDrawnUntilTheSwap) {
    const Scene before({1, 2}, 3), after({3, 4}, 30);
    upload(before);
    begin(after);
    for (int i = 0; i < 3; ++i) {
        draw(before);
        ASSERT_TRUE(renderer_.advance(300));
    }
    advanceToTheEnd(1 << 20);
    draw(before);
    renderer_.swap();
    draw(after);
}

TEST_P(StagedScenes, commonContentIsShared) {
    const Scene before({1, 2, 3, 4}, 3), after({4, 3, 2, 1}, 5);
    upload(before);
    draw(before);
    const std::size_t textures = device_.textures, programs = device_.programs;
    device_.levels.clear();
    begin(after);
    advanceToTheEnd(1 << 20);
    renderer_.swap();
    draw(after);
    EXPECT_EQ(device_.textures, textures) << "none is created again";
    EXPECT_TRUE(device_.levels.empty()) << "none is written";
    EXPECT_EQ(device_.programs, programs);
}

TEST_P(StagedScenes, aSmallerSceneNeedsNoOtherPrograms) {
    const Scene both({1, 2}, 3), one({1}, 3), again({2, 3, 1}, 3);
    upload(both);
    draw(both);
    const std::size_t programs = device_.programs;
    for (const Scene* next : {&one, &again, &both}) {
        begin(*next);
        advanceToTheEnd(1 << 20);
        renderer_.swap();
        draw(*next);
        EXPECT_EQ(device_.programs, programs);
    }
}

/// Ground with a base, and with an overlay and its blend map if `hasOverlay`.
Scene ground(bool hasOverlay) {
    Scene scene({1, 3, 2}, 1); // the third texture has another size
    layout::TerrainCell cell;
    const layout::TerrainLayer none{layout::kNoTexture, layout::kNoTexture, 0, 1.0f};
    cell.base = {0, layout::kNoTexture, 0, 1.0f};
    std::fill(std::begin(cell.overlays), std::end(cell.overlays), none);
    std::fill(std::begin(cell.roads), std::end(cell.roads), none);
    if (hasOverlay)
        cell.overlays[0] = {1, 2, 0, 1.0f};
    scene.builder.upload.terrainCells = {cell};
    return scene;
}

// Without a card, the programs of the ground have its pages as constants.
TEST(StagedGround, withoutMapsOrWithoutGround_needsNoOtherPrograms) {
    Capabilities capabilities = capabilitiesOf(false);
    capabilities.software = true;
    NullDevice device(capabilities);
    Renderer renderer(device, {.drawing = Drawing::Fast});
    ASSERT_TRUE(renderer.upload(ground(true).builder.upload));
    const SceneState before = renderer.state();
    ASSERT_TRUE(before.bindings->terrain.ground);
    EXPECT_NE(before.bindings->terrain.ground->colours, before.bindings->terrain.ground->maps);
    for (const Scene& next : {ground(false), Scene({1}, 1), ground(true)}) {
        const Result<StagedScene> staged =
            stageScene(next.builder.upload, renderer.options(), device.capabilities(), before);
        ASSERT_TRUE(staged);
        EXPECT_TRUE(staged->bindings == *before.bindings);
    }
}

TEST_P(StagedScenes, retiredSceneIsReleasedWhenNoFrameReadsIt) {
    const Scene before({1, 2, 3}, 3), after({3, 5, 8}, 3);
    upload(after);
    draw(after);
    const DeviceObjects alone = null_.objects();
    const std::size_t buffersOfOne = device_.reserved;
    upload(before);
    draw(before);
    for (const Scene* next : {&after, &before, &after}) {
        begin(*next);
        advanceToTheEnd(500);
        draw(next == &after ? before : after);
        renderer_.swap();
        const std::size_t live = null_.liveObjects();
        for (std::size_t frame = 0; frame < kFramesInFlight; ++frame) {
            ASSERT_TRUE(renderer_.advance(500));
            EXPECT_EQ(null_.liveObjects(), live) << "frames in flight read it";
            draw(*next);
        }
        for (int i = 0; i < 40; ++i) {
            ASSERT_TRUE(renderer_.advance(500));
            draw(*next);
        }
    }
    EXPECT_EQ(null_.objects().buffers, alone.buffers + buffersOfOne) << "the buffers of one scene are spare";
    EXPECT_EQ(null_.objects().residentHandles, alone.residentHandles);
    EXPECT_EQ(null_.objects().textures, alone.textures);
}

TEST_P(StagedScenes, droppedSceneLeavesNoObjects) {
    const Scene scene({1, 2}, 3), other({2, 4, 6, 8}, 30);
    upload(scene);
    draw(scene);
    const DeviceObjects objects = null_.objects();
    for (const std::size_t slices : {1, 4, 10}) {
        begin(other);
        for (std::size_t i = 0; i < slices; ++i)
            ASSERT_TRUE(renderer_.advance(900));
        renderer_.drop();
        for (int i = 0; i < 40; ++i) {
            ASSERT_TRUE(renderer_.advance(900));
            draw(scene);
        }
        DeviceObjects now = null_.objects();
        now.programs = objects.programs; // some programs are kept for later scenes, as are buffers
        EXPECT_LE(now.buffers, 2 * objects.buffers);
        now.buffers = objects.buffers;
        now.bufferBytes = objects.bufferBytes;
        EXPECT_EQ(now, objects);
    }
}

TEST_P(StagedScenes, laterScenesReuseBuffers) {
    const Scene first({1, 2}, 30), second({1, 2}, 33);
    upload(first);
    draw(first);
    const auto goOnTo = [&](const Scene& scene) {
        begin(scene);
        advanceToTheEnd(5000);
        renderer_.swap();
        for (int i = 0; i < 40; ++i) {
            ASSERT_TRUE(renderer_.advance(5000));
            draw(scene);
        }
    };
    goOnTo(second);
    const std::size_t reserved = device_.reserved;
    const DeviceObjects objects = null_.objects();
    for (const Scene* next : {&first, &second, &first}) {
        goOnTo(*next);
        EXPECT_EQ(device_.reserved, reserved);
        EXPECT_EQ(null_.objects(), objects);
    }
    NullDevice null(capabilitiesOf(GetParam()));
    WritingDevice atOnce(null);
    Renderer other(atOnce);
    ASSERT_TRUE(other.upload(first.builder.upload));
    EXPECT_EQ(device_.arrays, atOnce.arrays) << "with the same content";
}

TEST_P(StagedScenes, afterMakeRoomTheNextSceneCreatesNoBuffers) {
    const Scene first({1, 2}, 30), second({1, 2}, 33);
    upload(first);
    draw(first);
    ASSERT_TRUE(renderer_.makeRoom());
    const std::size_t reserved = device_.reserved;
    begin(second);
    advanceToTheEnd(5000);
    renderer_.swap();
    draw(second);
    EXPECT_EQ(device_.reserved, reserved);
}

TEST_P(StagedScenes, unusedSpareBuffersAreDestroyed) {
    const Scene large({1, 2}, 40'000), small({1, 2}, 2);
    upload(large);
    draw(large);
    const std::size_t bytes = null_.objects().bufferBytes;
    for (const Scene* next : {&small, &small}) {
        begin(*next);
        advanceToTheEnd(1 << 20);
        renderer_.swap();
        for (int i = 0; i < 40; ++i) {
            ASSERT_TRUE(renderer_.advance(5000));
            draw(*next);
        }
    }
    EXPECT_LT(null_.objects().bufferBytes, bytes / 2);
}

TEST_P(StagedScenes, sceneStagedBesideAnotherIsRefusedWithoutItsTextures) {
    const Scene first({2, 4}, 3), second({6, 8, 10}, 3), third({2, 4}, 5);
    upload(first);
    Result<StagedScene> staged =
        stageScene(third.builder.upload, renderer_.options(), device_.capabilities(), renderer_.state());
    ASSERT_TRUE(staged);
    upload(second);
    draw(second);
    ASSERT_TRUE(renderer_.begin(std::move(*staged)));
    const Result<bool> advanced = renderer_.advance(1 << 20);
    ASSERT_FALSE(advanced);
    EXPECT_EQ(advanced.error().code, ErrorCode::BadArgument);
    draw(second);
}

INSTANTIATE_TEST_SUITE_P(Bindings, StagedScenes, ::testing::Bool(),
                         [](const auto& about) { return about.param ? "bindless" : "pages"; });

} // namespace
} // namespace limen::gpu::test
