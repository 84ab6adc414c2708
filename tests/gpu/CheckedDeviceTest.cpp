#include "gpu/device/CheckedDevice.h"

#include "frame/GpuLayout.h"
#include "gpu/device/NullDevice.h"
#include "gpu/texture/TextureStore.h"

#include <array>
#include <gtest/gtest.h>
#include <map>

namespace limen::gpu::test {
namespace {

namespace layout = frame::gpu;

Capabilities withHandles() {
    Capabilities capabilities = NullDevice::defaultCapabilities();
    capabilities.bindless = true;
    return capabilities;
}

/// A device with one texture whose handle is in the bound references, and a program that samples by handle.
struct Watched {
    NullDevice null{withHandles()};
    CheckedDevice device{null};
    TargetHandle target = *device.createTarget(4, 4, {});
    TextureHandle texture = *device.createTexture("brick", {2, 2});
    std::uint64_t handle = device.residentHandle(texture);
    ProgramHandle byHandle = *device.createProgram({.label = "by handle", .textures = {.bindless = true}});
    ProgramHandle plain = *device.createProgram({.label = "plain"});
    BufferHandle references = makeReferences(handle);
    std::map<BufferHandle, TextureHandle> texels; ///< views of the references

    Watched() { EXPECT_TRUE(device.reserveRing(1024)); }

    BufferHandle makeReferences(std::uint64_t of) {
        layout::TextureRef reference;
        reference.place = {static_cast<std::uint32_t>(of), static_cast<std::uint32_t>(of >> 32), 2, 2};
        return *device.createBuffer("references", std::as_bytes(std::span(&reference, 1)));
    }
    void begin() {
        if (!texels.contains(references))
            texels[references] = *device.createTexels("references", references);
        static_cast<void>(device.beginFrame(target, {}));
        device.bindStorage(std::array{StorageRange{references, 0, sizeof(layout::TextureRef)}});
        const std::vector<TextureHandle> textures(layout::kUnitTextures - layout::kUnitVertices + 1,
                                                  texels[references]);
        device.bindTextures(textures, false);
    }
    void draw(ProgramHandle program) {
        device.setState({.program = program});
        device.drawVertices(0, 3);
    }
    void frame() {
        begin();
        draw(byHandle);
        EXPECT_TRUE(device.endFrame());
    }
    /// The only fault.
    std::string fault() const {
        EXPECT_EQ(device.faults().size(), 1u);
        return device.faults().empty() ? "" : device.faults().front();
    }
};

TEST(CheckedDevice, finishedFramesThenReleaseThenDestructionIsRight) {
    Watched w;
    w.frame();
    w.frame();
    w.device.finishFrames();
    w.device.releaseHandle(w.texture);
    w.device.destroyTexture(w.texture);
    w.device.destroyBuffer(w.references);
    EXPECT_TRUE(w.device.faults().empty()) << w.device.faults().front();
}

TEST(CheckedDevice, sampledHandlesMustBeResident) {
    Watched w;
    w.device.releaseHandle(w.texture);
    w.begin();
    w.draw(w.plain);
    EXPECT_TRUE(w.device.faults().empty()) << "that program samples no handle";
    w.draw(w.byHandle);
    EXPECT_EQ(w.fault(), "handle 0x1 may be sampled but is not resident");
}

TEST(CheckedDevice, anInventedHandleIsNotResident) {
    Watched w;
    w.references = w.makeReferences(0xABCDEF0123ull);
    w.frame();
    EXPECT_EQ(w.fault(), "handle 0xabcdef0123 may be sampled but is not resident");
}

TEST(CheckedDevice, aHandleReleasedAfterTheCheckIsReported) {
    Watched w;
    w.frame();
    w.device.finishFrames();
    w.device.releaseHandle(w.texture);
    w.frame();
    EXPECT_EQ(w.fault(), "handle 0x1 may be sampled but is not resident");
}

TEST(CheckedDevice, noHandleIsReleasedWhileAFrameInFlightSamplesIt) {
    Watched w;
    w.frame();
    w.device.releaseHandle(w.texture);
    EXPECT_EQ(w.fault(), "the handle of 'brick' is released while a frame in flight samples it");
}

TEST(CheckedDevice, noHandleIsReleasedInTheFrameThatSamplesIt) {
    Watched w;
    w.begin();
    w.draw(w.byHandle);
    w.device.releaseHandle(w.texture);
    EXPECT_EQ(w.fault(), "the handle of 'brick' is released while a frame in flight samples it");
}

TEST(CheckedDevice, aFrameIsDoneWhenTheDeviceHasWaitedForIt) {
    for (const bool reads : {false, true}) {
        Watched w;
        w.frame();
        const BufferHandle old = w.references;
        w.references = w.makeReferences(0); // samples nothing
        if (reads) {
            std::vector<std::byte> pixels(64);
            w.device.readTarget(w.target, TargetImage::Colour, pixels);
        } else {
            for (std::size_t i = 0; i < kFramesInFlight; ++i)
                w.frame();
        }
        w.device.releaseHandle(w.texture);
        EXPECT_TRUE(w.device.faults().empty()) << w.device.faults().front();
        w.device.destroyBuffer(old);
    }
    Watched early;
    early.frame();
    early.references = early.makeReferences(0);
    for (std::size_t i = 1; i < kFramesInFlight; ++i)
        early.frame();
    early.device.releaseHandle(early.texture);
    EXPECT_EQ(early.device.faults().size(), 1u) << "the oldest may still be in flight";
}

TEST(CheckedDevice, aBufferIsNotRefilledWhileAFrameReadsIt) {
    Watched watched;
    watched.frame();
    watched.device.refillBuffer("references", watched.references);
    EXPECT_NE(watched.fault().find("is refilled while a frame"), std::string::npos);
}

TEST(CheckedDevice, aBufferMayBeRefilledWhenItsFramesAreComplete) {
    Watched watched;
    watched.frame();
    watched.device.finishFrames();
    watched.device.refillBuffer("references", watched.references);
    EXPECT_TRUE(watched.device.faults().empty());
}

TEST(CheckedDevice, releaseComesBeforeDestruction) {
    Watched w;
    w.device.destroyTexture(w.texture);
    EXPECT_EQ(w.fault(), "'brick' is destroyed before its handle is released");
}

TEST(CheckedDevice, destroyedObjectsMustNotBeUsed) {
    Watched w;
    w.frame();
    w.device.finishFrames();
    w.device.destroyBuffer(w.references);
    w.begin();
    EXPECT_EQ(w.fault(), "buffer 0 is bound but does not exist");
    Watched textures;
    textures.device.releaseHandle(textures.texture);
    textures.device.destroyTexture(textures.texture);
    textures.begin();
    textures.device.bindTextures(std::span(&textures.texture, 1), false);
    EXPECT_EQ(textures.fault(), "texture 0 is bound but does not exist");
    Watched programs;
    programs.device.destroyProgram(programs.plain);
    programs.begin();
    programs.draw(programs.plain);
    EXPECT_EQ(programs.fault(), "program 1 is used but does not exist");
    Watched geometry;
    geometry.device.setGeometry(geometry.references, static_cast<BufferHandle>(77));
    EXPECT_EQ(geometry.fault(), "buffer 77 is set as geometry but does not exist");
}

TEST(CheckedDevice, resourcesAreCreatedBetweenFrames) {
    Watched w;
    w.begin();
    static_cast<void>(w.device.createBuffer("late", {}));
    EXPECT_EQ(w.fault(), "a buffer is created during a frame");
}

TEST(CheckedDevice, aTextureStoreKeepsTheRules) {
    NullDevice null{withHandles()};
    CheckedDevice device{null};
    const std::vector<std::uint8_t> texels(16);
    std::vector<frame::TextureUpload> uploads(3);
    for (frame::TextureUpload& upload : uploads) {
        upload.width = upload.height = 2;
        upload.rgba = texels;
    }
    static_cast<void>(TextureStore::create(device, uploads, {}));
    EXPECT_TRUE(device.faults().empty()) << device.faults().front();
    EXPECT_EQ(null.liveObjects(), 0u);
}

} // namespace
} // namespace limen::gpu::test
