#include "gpu/device/GlDevice.h"

#include "core/Assert.h"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

namespace limen::gpu {
namespace {

constexpr std::size_t kMaxBindings = frame::gpu::kStorageBindings; // bound in one call
constexpr GLuint kFirstBinding =
    frame::gpu::kBindFrame + 1;       // of storage; the frame's constants are a uniform block
constexpr GLuint kFirstUnit = 0;      // arrays passed to glBind...s are indexed by binding and unit
constexpr GLint kDepthDrawBuffer = 0; // the only number that OpenGL accepts for depth
constexpr std::size_t kMaxUnits = 64;
constexpr GLfloat kClearDepth = 0.0f; // the far plane
constexpr GLuint64 kFenceTimeoutNanoseconds = 1'000'000'000;

const void* byteOffset(std::size_t offset) {
    return reinterpret_cast<const void*>(offset); // GL passes the offset into the bound buffer as a pointer
}

} // namespace

std::string lossMessage(unsigned status) {
    const char* cause = status == GL_GUILTY_CONTEXT_RESET     ? "because of a command of this program"
                        : status == GL_INNOCENT_CONTEXT_RESET ? "because of another program"
                                                              : "for an unknown reason";
    return fmt::format("the graphics device was reset {}; restart the program", cause);
}

void GlDevice::restoreState() {
    glDisable(GL_DITHER);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GEQUAL);
    for (GLenum i = 0; i < kClipDistances; ++i)
        glDisable(GL_CLIP_DISTANCE0 + i);
    glDepthMask(GL_TRUE);
    glDisable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    glFrontFace(GL_CCW);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_BLEND);
    glEnablei(GL_BLEND, frame::gpu::kOutputBlended);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    const glm::vec4 clear = StateTracker::kFirstClearColour;
    glClearColor(clear.x, clear.y, clear.z, clear.w);
    glClearDepthf(kClearDepth);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glBindVertexArray(vertexArray_.id());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, ring_.id());
    for (GLuint unit = 0; unit < capabilities_.textureUnits; ++unit)
        glBindSampler(unit, 0);
    const Viewport viewport = state_.viewport();
    glViewport(viewport.x, viewport.y, static_cast<GLsizei>(viewport.width),
               static_cast<GLsizei>(viewport.height));
    state_ = StateTracker{};
    static_cast<void>(state_.setViewport(viewport));
}

// Waits until the GPU no longer reads a ring slot. Counted calls are part of a frame.
void GlDevice::waitForFence(std::size_t slot, bool counted) {
    if (fences_[slot] == nullptr)
        return;
    const std::uint32_t before = frameCalls_;
    GLenum result = call(glClientWaitSync, fences_[slot], GL_SYNC_FLUSH_COMMANDS_BIT, GLuint64{0});
    if (result == GL_TIMEOUT_EXPIRED) {
        ++ringStalls_;
        while (result == GL_TIMEOUT_EXPIRED) // counts as one call however often it repeats
            result = glClientWaitSync(fences_[slot], GL_SYNC_FLUSH_COMMANDS_BIT, kFenceTimeoutNanoseconds);
    }
    isLost_ = isLost_ || result == GL_WAIT_FAILED;
    call(glDeleteSync, fences_[slot]);
    fences_[slot] = nullptr;
    if (!counted)
        frameCalls_ = before;
}

void GlDevice::finishFrames() {
    LIMEN_ASSERT(frameTarget_ == nullptr, "the current frame has ended");
    for (GLsync fence : fences_) {
        while (fence != nullptr && glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT,
                                                    kFenceTimeoutNanoseconds) == GL_TIMEOUT_EXPIRED) {
        }
    }
}

Result<void> GlDevice::reserveRing(std::size_t bytes) {
    LIMEN_ASSERT(frameTarget_ == nullptr, "the ring grows between frames");
    if (bytes <= ringSlotSize_)
        return {};
    constexpr std::size_t kSmallestSlot = std::size_t{1} << 18;
    const std::size_t alignment =
        std::max<std::size_t>(capabilities_.storageAlignment, sizeof(frame::gpu::DrawRecord));
    const std::size_t wanted = std::max(bytes + bytes / 2, kSmallestSlot);
    const std::size_t slotSize = (wanted + alignment - 1) / alignment * alignment;
    if (slotSize / kBytesPerTexel > capabilities_.maxBufferTexels) {
        return fail(
            ErrorCode::Unsupported, "a frame",
            fmt::format("needs {} bytes, but a buffer has at most {} texels on {}; choose a smaller --radius",
                        bytes, capabilities_.maxBufferTexels, capabilities_.renderer));
    }
    Result<Buffer> ring = Buffer::createMapped("frame ring", slotSize * kFramesInFlight);
    if (!ring)
        return Failure(ring.error());
    for (std::size_t slot = 0; slot < kFramesInFlight; ++slot) {
        waitForFence(slot, false);
        // Every slot has a fence from the start, so that the first frames make the same calls as later ones.
        fences_[slot] = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    }
    ringStalls_ += ring_.empty() ? 0 : 1;
    ring_ = std::move(*ring);
    ringSlotSize_ = slotSize;
    for (std::size_t slot = 0; slot < kFramesInFlight; ++slot)
        ringTexels_[slot] = Texture::createBufferView("frame ring", ring_.id(), slot * slotSize, slotSize);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, ring_.id());
    glVertexArrayVertexBuffer(vertexArray_.id(), kRecordSlot, ring_.id(), 0,
                              static_cast<GLsizei>(sizeof(frame::gpu::DrawRecord)));
    return {};
}

std::span<std::byte> GlDevice::beginFrame(TargetHandle target, const Viewport& viewport) {
    LIMEN_ASSERT(frameTarget_ == nullptr, "the last frame has ended");
    LIMEN_ASSERT(!ring_.empty(), "the ring is reserved");
    frameTarget_ = targets_[static_cast<std::size_t>(target)].get();
    LIMEN_ASSERT(frameTarget_ != nullptr, "the target exists");
    timers_.beginFrame();
    frameCalls_ = 0;
    ringSlot_ = (ringSlot_ + 1) % kFramesInFlight;
    waitForFence(ringSlot_, true);
    if (state_.setViewport(viewport))
        call(glViewport, viewport.x, viewport.y, static_cast<GLsizei>(viewport.width),
             static_cast<GLsizei>(viewport.height));
    return ring_.mapped().subspan(ringSlot_ * ringSlotSize_, ringSlotSize_);
}

void GlDevice::bindStorage(std::span<const StorageRange> ranges) {
    LIMEN_ASSERT(!ranges.empty() && ranges.size() <= kMaxBindings, "bindings of SharedLayout.h");
    std::array<GLuint, kMaxBindings> names{};
    std::array<GLintptr, kMaxBindings> offsets{};
    std::array<GLsizeiptr, kMaxBindings> sizes{};
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        const StorageRange& range = ranges[i];
        const bool inRing = range.buffer == BufferHandle::Invalid;
        const Buffer& buffer = inRing ? ring_ : buffers_[static_cast<std::size_t>(range.buffer)];
        names[i] = buffer.id();
        offsets[i] = static_cast<GLintptr>(range.offset + (inRing ? ringSlot_ * ringSlotSize_ : 0));
        sizes[i] = static_cast<GLsizeiptr>(range.size);
    }
    constexpr std::size_t kFrame = frame::gpu::kBindFrame;
    call(glBindBufferRange, GLenum{GL_UNIFORM_BUFFER}, GLuint{kFrame}, names[kFrame], offsets[kFrame],
         sizes[kFrame]);
    if (ranges.size() > kFirstBinding)
        call(glBindBuffersRange, GLenum{GL_SHADER_STORAGE_BUFFER}, kFirstBinding,
             static_cast<GLsizei>(ranges.size() - kFirstBinding), &names[kFirstBinding],
             &offsets[kFirstBinding], &sizes[kFirstBinding]);
}

void GlDevice::bindTextures(std::span<const TextureHandle> textures, bool withDrawn) {
    LIMEN_ASSERT(!withDrawn || !frameTarget_->isMultisampled(), "shaders read one sample a pixel");
    LIMEN_ASSERT(textures.size() + frame::gpu::kUnitVertices <= kMaxUnits, "units that the driver has");
    std::array<GLuint, kMaxUnits> names{};
    names[frame::gpu::kUnitOwnership] = frameTarget_->ownership.id();
    names[frame::gpu::kUnitRing] = ringTexels_[ringSlot_].id();
    names[frame::gpu::kUnitDepth] = frameTarget_->depth.id();
    for (std::size_t i = 0; i < textures.size(); ++i)
        names[frame::gpu::kUnitVertices + i] = textures_[static_cast<std::size_t>(textures[i])].id();
    if (withDrawn) {
        names[frame::gpu::kUnitColour] = frameTarget_->colour.id();
        names[frame::gpu::kUnitId] = frameTarget_->id.id();
    }
    call(glBindTextures, kFirstUnit, static_cast<GLsizei>(textures.size() + frame::gpu::kUnitVertices),
         names.data());
}

void GlDevice::readDrawn() {
    call(glTextureBarrier);
}

std::uint32_t GlDevice::baseInstanceAt(std::size_t offset) const {
    const std::size_t place = ringSlot_ * ringSlotSize_ + offset;
    LIMEN_ASSERT(place % sizeof(frame::gpu::DrawRecord) == 0, "records begin at a multiple of their size");
    return static_cast<std::uint32_t>(place / sizeof(frame::gpu::DrawRecord));
}

void GlDevice::compute(ProgramHandle program, const WorkGroups& groups) {
    setState(state_.with(program));
    call(glDispatchCompute, GLuint{groups.columns}, GLuint{groups.rows}, GLuint{groups.layers});
    call(glMemoryBarrier,
         GLbitfield{GL_COMMAND_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT});
}

void GlDevice::clear(TargetImage image, const ClearValue& value) {
    const auto framebufferOf = [&](Pass pass) {
        return frameTarget_->passes[static_cast<std::size_t>(pass)].id();
    };
    switch (image) {
    case TargetImage::Colour:
        call(glClearNamedFramebufferfv, framebufferOf(Pass::SolidNoIds), GLenum{GL_COLOR},
             static_cast<GLint>(frame::gpu::kOutputColour), &std::get<glm::vec4>(value).x);
        return;
    case TargetImage::Layers:
        call(glClearNamedFramebufferfv, framebufferOf(Pass::Layers), GLenum{GL_COLOR},
             static_cast<GLint>(frame::gpu::kOutputBlended), &std::get<glm::vec4>(value).x);
        return;
    case TargetImage::Id:
        call(glClearNamedFramebufferuiv, framebufferOf(Pass::Solid), GLenum{GL_COLOR},
             static_cast<GLint>(frame::gpu::kOutputId), &std::get<std::uint32_t>(value));
        return;
    case TargetImage::Depth:
        if (state_.enableDepthWrite())
            call(glDepthMask, GLboolean{GL_TRUE});
        call(glClearNamedFramebufferfv, framebufferOf(Pass::SolidNoIds), GLenum{GL_DEPTH}, kDepthDrawBuffer,
             &std::get<float>(value));
        return;
    case TargetImage::Ownership:
        call(glClearNamedFramebufferuiv, framebufferOf(Pass::Ownership), GLenum{GL_COLOR},
             static_cast<GLint>(frame::gpu::kOutputVisit), &std::get<std::uint32_t>(value));
        return;
    }
}

void GlDevice::clearPicture(const glm::vec4& colour) {
    if (state_.enableDepthWrite())
        call(glDepthMask, GLboolean{GL_TRUE});
    if (state_.setClearColour(colour))
        call(glClearColor, colour.x, colour.y, colour.z, colour.w);
    call(glClear, GLbitfield{GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT});
}

void GlDevice::flush() {
    call(glFlush);
}

void GlDevice::beginPass(Pass pass) {
    call(glBindFramebuffer, GLenum{GL_DRAW_FRAMEBUFFER},
         frameTarget_->passes[static_cast<std::size_t>(pass)].id());
}

void GlDevice::setCulling(bool backFaces) {
    if (state_.setCulling(backFaces))
        (backFaces ? glEnable : glDisable)(GL_CULL_FACE);
}

void GlDevice::setState(const DrawState& state) {
    make(state_.apply(state), state);
}

void GlDevice::make(const StateTracker::Changes& changes, const DrawState& state) {
    if (changes.program)
        call(glUseProgram, programs_[static_cast<std::size_t>(state.program)].id());
    if (changes.cull)
        call(state.cullBackFaces ? glEnable : glDisable, GLenum{GL_CULL_FACE});
    if (changes.depthWrite)
        call(glDepthMask, state.writeDepth ? GLboolean{GL_TRUE} : GLboolean{GL_FALSE});
    if (changes.depthTest)
        call(glDepthFunc, state.depthTest == DepthTest::Always ? GLenum{GL_ALWAYS} : GLenum{GL_GEQUAL});
    for (GLenum i = 0; changes.clips && i < kClipDistances; ++i)
        call(state.clips ? glEnable : glDisable, GLenum{GL_CLIP_DISTANCE0 + i});
}

void GlDevice::drawVertices(std::uint32_t first, std::uint32_t count) {
    call(glDrawArrays, GLenum{GL_TRIANGLES}, static_cast<GLint>(first), static_cast<GLsizei>(count));
}

void GlDevice::drawIndirect(std::size_t offset, std::uint32_t count) {
    call(glMultiDrawElementsIndirect, GLenum{GL_TRIANGLES}, GLenum{GL_UNSIGNED_INT},
         byteOffset(ringSlot_ * ringSlotSize_ + offset), static_cast<GLsizei>(count), GLsizei{0});
}

void GlDevice::resolve() {
    const auto width = static_cast<GLint>(frameTarget_->width),
               height = static_cast<GLint>(frameTarget_->height);
    call(glBlitNamedFramebuffer, frameTarget_->passes[static_cast<std::size_t>(Pass::SolidNoIds)].id(),
         frameTarget_->resolvedPass.id(), 0, 0, width, height, 0, 0, width, height,
         GLbitfield{GL_COLOR_BUFFER_BIT}, GLenum{GL_NEAREST});
}

Result<void> GlDevice::endFrame() {
    LIMEN_ASSERT(frameTarget_ != nullptr, "a frame was begun");
    // Restores the state that every frame starts with, so that all frames make the same calls.
    const StateTracker::Changes changes = state_.reset();
    make(changes, state_.current());
    fences_[ringSlot_] = call(glFenceSync, GLenum{GL_SYNC_GPU_COMMANDS_COMPLETE}, GLbitfield{0});
    frameTarget_ = nullptr;
    lastFrameCalls_ = frameCalls_;
    if (isLost_)
        return fail(ErrorCode::Driver, driver_, lossMessage(glGetGraphicsResetStatus()));
    return {};
}

void GlDevice::presentToWindow(TargetHandle target, std::uint32_t width, std::uint32_t height) {
    const Target& from = *targets_[static_cast<std::size_t>(target)];
    window_.show({from.shown().id(), from.shownColour().id(), from.width, from.height}, {0, width, height});
    restoreState();
}

GlDevice::PictureNames GlDevice::namesOf(TargetHandle target) const {
    const Target& of = *targets_[static_cast<std::size_t>(target)];
    return {of.shown().id(), of.shownColour().id(), of.id.id(), of.depth.id()};
}

Result<void> GlDevice::copyTo(TargetHandle target, GLuint framebuffer, std::int32_t x, std::int32_t y) {
    const auto name = [&] { return fmt::format("framebuffer {}", framebuffer); };
    if (framebuffer != 0 && glIsFramebuffer(framebuffer) == GL_FALSE)
        return fail(ErrorCode::BadArgument, name(), "does not exist; create it, and bind it once");
    if (const GLenum status = glCheckNamedFramebufferStatus(framebuffer, GL_DRAW_FRAMEBUFFER);
        status != GL_FRAMEBUFFER_COMPLETE)
        return fail(ErrorCode::BadArgument, name(),
                    fmt::format("is not complete (0x{:04X}); attach a colour image", status));
    const Target& from = *targets_[static_cast<std::size_t>(target)];
    const auto width = static_cast<GLint>(from.width), height = static_cast<GLint>(from.height);
    glNamedFramebufferReadBuffer(from.shown().id(), GL_COLOR_ATTACHMENT0);
    glBlitNamedFramebuffer(from.shown().id(), framebuffer, 0, 0, width, height, x, y, x + width, y + height,
                           GL_COLOR_BUFFER_BIT, GL_NEAREST);
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        return fail(
            ErrorCode::Driver, name(),
            fmt::format(
                "the driver refuses to copy the picture into it (0x{:04X}); it needs a colour image that "
                "is not of integers",
                error));
    return {};
}

} // namespace limen::gpu
