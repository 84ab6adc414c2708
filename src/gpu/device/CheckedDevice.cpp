#include "gpu/device/CheckedDevice.h"

#include "frame/GpuLayout.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>

#include <fmt/format.h>

namespace limen::gpu {
namespace {

namespace layout = frame::gpu;

constexpr std::size_t kMostFaults = 100;
static_assert(std::endian::native == std::endian::little);

/// Calls visit(handle) for each texture reference until it yields true, and yields whether it did.
template <class Visit>
bool anyHandle(std::span<const std::byte> references, Visit visit) {
    for (std::size_t at = 0; at + sizeof(layout::TextureRef) <= references.size();
         at += sizeof(layout::TextureRef)) {
        static_assert(offsetof(layout::TextureRef, place) == 0);
        std::uint64_t handle = 0; // the low word, then the high word
        std::memcpy(&handle, references.data() + at, sizeof handle);
        if (handle != 0 && visit(handle)) // 0: padding
            return true;
    }
    return false;
}

} // namespace

void CheckedDevice::fault(std::string what) {
    if (faults_.size() < kMostFaults)
        faults_.push_back(std::move(what));
}

void CheckedDevice::expectBetweenFrames(std::string_view command) {
    if (inFrame_)
        fault(fmt::format("{} during a frame", command));
}

void CheckedDevice::expectBuffer(BufferHandle buffer, std::string_view use) {
    if (buffer != BufferHandle::Invalid && !buffers_.contains(buffer))
        fault(fmt::format("buffer {} {} but does not exist", static_cast<std::uint32_t>(buffer), use));
}

void CheckedDevice::expectTexture(TextureHandle texture, std::string_view use) {
    if (!textures_.contains(texture))
        fault(fmt::format("texture {} {} but does not exist", static_cast<std::uint32_t>(texture), use));
}

void CheckedDevice::expectProgram(ProgramHandle program) {
    if (!programs_.contains(program))
        fault(fmt::format("program {} is used but does not exist", static_cast<std::uint32_t>(program)));
}

bool CheckedDevice::holds(const Bytes& references, std::uint64_t handle) {
    return references && anyHandle(*references, [&](std::uint64_t other) { return other == handle; });
}

Result<BufferHandle> CheckedDevice::createBuffer(std::string_view label, std::span<const std::byte> bytes) {
    expectBetweenFrames("a buffer is created");
    Result<BufferHandle> buffer = ForwardingDevice::createBuffer(label, bytes);
    if (buffer) {
        buffers_[*buffer] = capabilities().bindless
                                ? std::make_shared<const std::vector<std::byte>>(bytes.begin(), bytes.end())
                                : nullptr;
    }
    return buffer;
}

Result<BufferHandle> CheckedDevice::reserveBuffer(std::string_view label, std::size_t bytes) {
    expectBetweenFrames("a buffer is created");
    Result<BufferHandle> buffer = ForwardingDevice::reserveBuffer(label, bytes);
    if (buffer) {
        buffers_[*buffer] =
            capabilities().bindless ? std::make_shared<const std::vector<std::byte>>(bytes) : nullptr;
    }
    return buffer;
}

void CheckedDevice::writeBuffer(BufferHandle buffer, std::size_t offset, std::span<const std::byte> bytes) {
    expectBetweenFrames("a buffer is written");
    expectBuffer(buffer, "is written");
    const auto found = buffers_.find(buffer);
    if (found != buffers_.end() && found->second) {
        if (offset + bytes.size() > found->second->size()) {
            fault(fmt::format("buffer {} is written beyond its end", static_cast<std::uint32_t>(buffer)));
            return;
        }
        if (found->second.use_count() > 1) // a frame has read it
            fault(fmt::format("buffer {} is written after it was read", static_cast<std::uint32_t>(buffer)));
        auto written = std::make_shared<std::vector<std::byte>>(*found->second);
        std::copy(bytes.begin(), bytes.end(), written->begin() + static_cast<std::ptrdiff_t>(offset));
        found->second = std::move(written);
    }
    ForwardingDevice::writeBuffer(buffer, offset, bytes);
}

void CheckedDevice::refillBuffer(std::string_view label, BufferHandle buffer) {
    expectBetweenFrames("a buffer is refilled");
    expectBuffer(buffer, "is refilled");
    if (const auto found = buffers_.find(buffer); found != buffers_.end() && found->second) {
        const auto isRead = [&](const std::vector<Bytes>& frame) {
            return std::find(frame.begin(), frame.end(), found->second) != frame.end();
        };
        if (std::any_of(underWay_.begin(), underWay_.end(), isRead)) {
            fault(fmt::format("buffer {} is refilled while a frame in flight reads it",
                              static_cast<std::uint32_t>(buffer)));
        }
        found->second = std::make_shared<const std::vector<std::byte>>(found->second->size());
    }
    ForwardingDevice::refillBuffer(label, buffer);
}

Result<BufferHandle> CheckedDevice::createScratch(std::string_view label, std::size_t bytes) {
    expectBetweenFrames("a buffer is created");
    Result<BufferHandle> buffer = ForwardingDevice::createScratch(label, bytes);
    if (buffer)
        buffers_[*buffer] = nullptr;
    return buffer;
}

void CheckedDevice::destroyBuffer(BufferHandle buffer) {
    expectBetweenFrames("a buffer is destroyed");
    expectBuffer(buffer, "is destroyed");
    buffers_.erase(buffer);
    ForwardingDevice::destroyBuffer(buffer);
}

Result<TextureHandle> CheckedDevice::createTexels(std::string_view label, BufferHandle buffer) {
    expectBetweenFrames("a texture is created");
    expectBuffer(buffer, "is viewed as texels");
    Result<TextureHandle> texture = ForwardingDevice::createTexels(label, buffer);
    if (texture)
        textures_[*texture] = {std::string(label), 0, buffer};
    return texture;
}

Result<TextureHandle> CheckedDevice::createTexture(std::string_view label, const TextureShape& shape) {
    expectBetweenFrames("a texture is created");
    Result<TextureHandle> texture = ForwardingDevice::createTexture(label, shape);
    if (texture)
        textures_[*texture] = {std::string(label)};
    return texture;
}

std::uint64_t CheckedDevice::residentHandle(TextureHandle texture) {
    expectBetweenFrames("a handle is made resident");
    expectTexture(texture, "is made resident");
    const std::uint64_t handle = ForwardingDevice::residentHandle(texture);
    if (handle != 0) {
        textures_[texture].resident = handle;
        residents_[handle] = texture;
    }
    return handle;
}

void CheckedDevice::releaseHandle(TextureHandle texture) {
    expectTexture(texture, "is released");
    if (const auto found = textures_.find(texture); found != textures_.end() && found->second.resident != 0) {
        const std::uint64_t handle = found->second.resident;
        const auto maySample = [&](const std::vector<Bytes>& frame) {
            return std::any_of(frame.begin(), frame.end(),
                               [&](const Bytes& references) { return holds(references, handle); });
        };
        if (maySample(sampled_) || std::any_of(underWay_.begin(), underWay_.end(), maySample)) {
            fault(fmt::format("the handle of '{}' is released while a frame in flight samples it",
                              found->second.label));
        }
        residents_.erase(handle);
        found->second.resident = 0;
        sound_ = nullptr;
    }
    ForwardingDevice::releaseHandle(texture);
}

void CheckedDevice::destroyTexture(TextureHandle texture) {
    expectBetweenFrames("a texture is destroyed");
    expectTexture(texture, "is destroyed");
    if (const auto found = textures_.find(texture); found != textures_.end()) {
        if (found->second.resident != 0) {
            fault(fmt::format("'{}' is destroyed before its handle is released", found->second.label));
            residents_.erase(found->second.resident);
            sound_ = nullptr;
        }
        textures_.erase(found);
    }
    ForwardingDevice::destroyTexture(texture);
}

Result<ProgramHandle> CheckedDevice::createProgram(const ProgramSource& source) {
    expectBetweenFrames("a program is created");
    Result<ProgramHandle> program = ForwardingDevice::createProgram(source);
    if (program)
        programs_[*program] = source.textures.bindless;
    return program;
}

void CheckedDevice::destroyProgram(ProgramHandle program) {
    expectBetweenFrames("a program is destroyed");
    expectProgram(program);
    programs_.erase(program);
    ForwardingDevice::destroyProgram(program);
}

void CheckedDevice::readTarget(TargetHandle target, TargetImage image, std::span<std::byte> out) {
    ForwardingDevice::readTarget(target, image, out);
    underWay_.clear(); // frames end in order
}

void CheckedDevice::finishFrames() {
    ForwardingDevice::finishFrames();
    underWay_.clear();
}

void CheckedDevice::setGeometry(BufferHandle vertices, BufferHandle indices) {
    expectBuffer(vertices, "is set as geometry");
    expectBuffer(indices, "is set as geometry");
    ForwardingDevice::setGeometry(vertices, indices);
}

std::span<std::byte> CheckedDevice::beginFrame(TargetHandle target, const Viewport& viewport) {
    if (underWay_.size() == kFramesInFlight)
        underWay_.pop_front(); // the device waits for that frame
    inFrame_ = true;
    program_ = ProgramHandle::Invalid;
    references_ = nullptr;
    return ForwardingDevice::beginFrame(target, viewport);
}

void CheckedDevice::bindStorage(std::span<const StorageRange> ranges) {
    for (const StorageRange& range : ranges)
        expectBuffer(range.buffer, "is bound");
    ForwardingDevice::bindStorage(ranges);
}

void CheckedDevice::bindTextures(std::span<const TextureHandle> textures, bool withDrawn) {
    for (const TextureHandle texture : textures)
        expectTexture(texture, "is bound");
    constexpr std::size_t kReferences = layout::kUnitTextures - layout::kUnitVertices;
    references_ = nullptr;
    if (textures.size() > kReferences) {
        const auto texels = textures_.find(textures[kReferences]);
        const auto found = texels != textures_.end() ? buffers_.find(texels->second.viewed) : buffers_.end();
        references_ = found != buffers_.end() ? found->second : nullptr;
    }
    ForwardingDevice::bindTextures(textures, withDrawn);
}

void CheckedDevice::checkSampled() {
    const auto found = programs_.find(program_);
    if (found == programs_.end() || !found->second || !references_)
        return;
    if (sound_ != references_) {
        const bool astray = anyHandle(*references_, [&](std::uint64_t handle) {
            if (residents_.contains(handle))
                return false;
            fault(fmt::format("handle 0x{:x} may be sampled but is not resident", handle));
            return true;
        });
        sound_ = astray ? nullptr : references_;
    }
    if (std::find(sampled_.begin(), sampled_.end(), references_) == sampled_.end())
        sampled_.push_back(references_);
}

void CheckedDevice::compute(ProgramHandle program, const WorkGroups& groups) {
    expectProgram(program);
    ForwardingDevice::compute(program, groups);
}

void CheckedDevice::setState(const DrawState& state) {
    expectProgram(state.program);
    program_ = state.program;
    ForwardingDevice::setState(state);
}

void CheckedDevice::drawVertices(std::uint32_t first, std::uint32_t count) {
    checkSampled();
    ForwardingDevice::drawVertices(first, count);
}

void CheckedDevice::drawIndirect(std::size_t offset, std::uint32_t count) {
    checkSampled();
    ForwardingDevice::drawIndirect(offset, count);
}

Result<void> CheckedDevice::endFrame() {
    Result<void> ended = ForwardingDevice::endFrame();
    underWay_.push_back(std::move(sampled_));
    sampled_.clear();
    inFrame_ = false;
    return ended;
}

} // namespace limen::gpu
