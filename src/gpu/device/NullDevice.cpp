#include "gpu/device/NullDevice.h"

#include "core/Assert.h"

#include <algorithm>

namespace limen::gpu {

NullDevice::NullDevice(Capabilities capabilities) : capabilities_(std::move(capabilities)) {}

Capabilities NullDevice::defaultCapabilities() {
    Capabilities capabilities;
    capabilities.vendor = "Limen";
    capabilities.renderer = "null device";
    capabilities.version = "none";
    return capabilities;
}

Result<BufferHandle> NullDevice::createBuffer(std::string_view, std::span<const std::byte> bytes) {
    ++objects_.buffers;
    objects_.bufferBytes += bytes.size();
    bufferSizes_.push_back(bytes.size());
    buffers_.emplace_back(bytes.begin(), bytes.end());
    return static_cast<BufferHandle>(buffers_.size() - 1);
}

Result<BufferHandle> NullDevice::reserveBuffer(std::string_view, std::size_t bytes) {
    ++objects_.buffers;
    objects_.bufferBytes += bytes;
    bufferSizes_.push_back(bytes);
    buffers_.emplace_back().reserve(bytes);
    return static_cast<BufferHandle>(buffers_.size() - 1);
}

void NullDevice::writeBuffer(BufferHandle buffer, std::size_t offset, std::span<const std::byte> bytes) {
    std::vector<std::byte>& to = buffers_[static_cast<std::size_t>(buffer)];
    LIMEN_ASSERT(offset == to.size() && offset + bytes.size() <= to.capacity(), "filled in order");
    to.insert(to.end(), bytes.begin(), bytes.end());
}

void NullDevice::refillBuffer(std::string_view, BufferHandle buffer) {
    buffers_[static_cast<std::size_t>(buffer)].clear(); // keeps its memory
}

Result<BufferHandle> NullDevice::createScratch(std::string_view, std::size_t bytes) {
    ++objects_.buffers;
    objects_.bufferBytes += bytes;
    bufferSizes_.push_back(bytes);
    buffers_.emplace_back().reserve(bytes); // not written here, so it uses no memory, as with a driver
    return static_cast<BufferHandle>(buffers_.size() - 1);
}

void NullDevice::destroyBuffer(BufferHandle buffer) {
    --objects_.buffers;
    objects_.bufferBytes -= bufferSizes_[static_cast<std::size_t>(buffer)];
    // assigning {} would keep the memory
    std::vector<std::byte>().swap(buffers_[static_cast<std::size_t>(buffer)]);
}

Result<TextureHandle> NullDevice::createTexture(std::string_view label, const TextureShape& shape) {
    if (std::max(shape.width, shape.height) > capabilities_.maxTextureSize ||
        shape.layers > capabilities_.maxArrayLayers)
        return fail(ErrorCode::Unsupported, std::string(label), "is larger than this device allows");
    ++objects_.textures;
    textures_.push_back(shape);
    return static_cast<TextureHandle>(textures_.size() - 1);
}

Result<TextureHandle> NullDevice::createTexels(std::string_view, BufferHandle) {
    ++objects_.textures;
    textures_.emplace_back();
    return static_cast<TextureHandle>(textures_.size() - 1);
}

void NullDevice::writeTexture(TextureHandle texture, const TextureRows& rows,
                              std::span<const std::uint8_t> rgba) {
    const TextureShape& shape = textures_[static_cast<std::size_t>(texture)];
    LIMEN_ASSERT(rows.layer < shape.layers && rows.level < shape.levels, "a layer and level of the texture");
    LIMEN_ASSERT(rows.width == std::max(1u, shape.width >> rows.level) &&
                     rows.first + rows.count <= std::max(1u, shape.height >> rows.level),
                 "rows of the level");
    LIMEN_ASSERT(rgba.size() == std::size_t{rows.width} * rows.count * 4, "four bytes per texel");
}

std::uint64_t NullDevice::residentHandle(TextureHandle texture) {
    LIMEN_ASSERT(capabilities_.bindless, "handles need ARB_bindless_texture");
    ++objects_.residentHandles;
    return static_cast<std::uint64_t>(texture) + 1;
}

void NullDevice::releaseHandle(TextureHandle) {
    LIMEN_ASSERT(capabilities_.bindless, "handles need ARB_bindless_texture");
    --objects_.residentHandles;
}

void NullDevice::destroyTexture(TextureHandle) {
    --objects_.textures;
}

Result<ProgramHandle> NullDevice::createProgram(const ProgramSource& source) {
    for (const std::string& name : {source.vertexShader, source.fragmentShader, source.computeShader}) {
        if (name.empty())
            continue;
        if (const Result<std::string> text = shaderText(name, source); !text)
            return Failure(text.error());
    }
    ++objects_.programs;
    programs_.push_back(source);
    return static_cast<ProgramHandle>(programs_.size() - 1);
}

void NullDevice::destroyProgram(ProgramHandle) {
    --objects_.programs;
    state_.forgetProgram();
}

Result<TargetHandle> NullDevice::createTarget(std::uint32_t width, std::uint32_t height,
                                              const TargetOptions& options) {
    if (width == 0 || height == 0 || std::max(width, height) > capabilities_.maxTextureSize) {
        return fail(ErrorCode::BadArgument, "target",
                    "a picture has at least one pixel per side and at most the device's limit");
    }
    if (Result<void> checked = checkSamples(options.samples, capabilities_); !checked)
        return Failure(checked.error());
    static_cast<void>(state_.setViewport(firstViewport(width, height, options, capabilities_)));
    ++objects_.targets;
    return static_cast<TargetHandle>(targets_++);
}

std::vector<glm::vec2> NullDevice::samplePositions(TargetHandle) {
    return std::vector<glm::vec2>(frame::gpu::kSamples, glm::vec2(0.5f));
}

void NullDevice::destroyTarget(TargetHandle) {
    --objects_.targets;
}

void NullDevice::readTarget(TargetHandle, TargetImage, std::span<std::byte> out) {
    std::fill(out.begin(), out.end(), std::byte{0});
}

void NullDevice::setGeometry(BufferHandle, BufferHandle) {}

void NullDevice::setCulling(bool backFaces) {
    static_cast<void>(state_.setCulling(backFaces));
}

Result<void> NullDevice::reserveRing(std::size_t bytes) {
    if (bytes > ring_.size()) {
        ring_.resize(bytes + bytes / 2);
        objects_.ringBytes = ring_.size();
    }
    return {};
}

std::span<std::byte> NullDevice::beginFrame(TargetHandle, const Viewport& viewport) {
    commands_.clear();
    frameCalls_ = 2; // wait for the slot's fence, delete it
    frameCalls_ += state_.setViewport(viewport) ? 1 : 0;
    return ring_;
}

void NullDevice::record(CommandKind kind, std::size_t a, std::size_t b, std::uint32_t glCalls) {
    commands_.push_back({kind, a, b});
    frameCalls_ += glCalls;
}

void NullDevice::bindStorage(std::span<const StorageRange> ranges) {
    storage_.assign(ranges.begin(), ranges.end());
    record(CommandKind::BindStorage, ranges.size(), 0,
           ranges.size() > 1 ? 2 : 1); // the uniform block, storage
}

void NullDevice::bindTextures(std::span<const TextureHandle> textures, bool) {
    record(CommandKind::BindTextures, textures.size(), 0, 1);
}

std::uint32_t NullDevice::baseInstanceAt(std::size_t offset) const {
    return static_cast<std::uint32_t>(offset / sizeof(frame::gpu::DrawRecord));
}

void NullDevice::readDrawn() {
    record(CommandKind::ReadDrawn, 0, 0, 1);
}

void NullDevice::compute(ProgramHandle program, const WorkGroups& groups) {
    LIMEN_ASSERT(std::max(groups.columns, groups.rows) <= kMostGroups, "within the limit of every driver");
    const std::uint32_t changes = state_.apply(state_.with(program)).count();
    record(CommandKind::Compute, static_cast<std::size_t>(program),
           std::size_t{groups.columns} * groups.rows * groups.layers,
           changes + 2); // plus the memory barrier
}

void NullDevice::clear(TargetImage image, const ClearValue&) {
    const bool isMasked = image == TargetImage::Depth && state_.enableDepthWrite();
    record(CommandKind::Clear, static_cast<std::size_t>(image), 0, isMasked ? 2 : 1);
}

void NullDevice::clearPicture(const glm::vec4& colour) {
    const std::uint32_t changes =
        std::uint32_t{state_.enableDepthWrite()} + std::uint32_t{state_.setClearColour(colour)};
    record(CommandKind::ClearPicture, 0, 0, 1 + changes);
}

void NullDevice::flush() {
    record(CommandKind::Flush, 0, 0, 1);
}

void NullDevice::beginStage(frame::StageKind stage) {
    record(CommandKind::BeginStage, static_cast<std::size_t>(stage), 0, 0);
}

void NullDevice::endStage(frame::StageKind stage) {
    record(CommandKind::EndStage, static_cast<std::size_t>(stage), 0, 0);
}

void NullDevice::beginPass(Pass pass) {
    record(CommandKind::BeginPass, static_cast<std::size_t>(pass), 0, 1);
}

void NullDevice::setState(const DrawState& state) {
    record(CommandKind::SetState, static_cast<std::size_t>(state.program), 0, state_.apply(state).count());
}

void NullDevice::drawVertices(std::uint32_t first, std::uint32_t count) {
    record(CommandKind::DrawVertices, first, count, 1);
}

void NullDevice::drawIndirect(std::size_t offset, std::uint32_t count) {
    record(CommandKind::DrawIndirect, offset, count, 1);
}

void NullDevice::resolve() {
    record(CommandKind::Resolve, 0, 0, 1);
}

Result<void> NullDevice::endFrame() {
    // plus the fence
    frameCalls_ += state_.reset().count() + 1;
    lastFrameCalls_ = frameCalls_;
    return {};
}

} // namespace limen::gpu
