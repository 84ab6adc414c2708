#pragma once

#include "gpu/device/Device.h"

namespace limen::gpu {

/// Forwards all commands to another device. Base of devices that change or check a few of them.
class ForwardingDevice : public Device {
public:
    /// The device must outlive it.
    explicit ForwardingDevice(Device& device) : device_(device) {}

    [[nodiscard]] const Capabilities& capabilities() const override { return device_.capabilities(); }
    [[nodiscard]] Result<BufferHandle> createBuffer(std::string_view label,
                                                    std::span<const std::byte> bytes) override {
        return device_.createBuffer(label, bytes);
    }
    [[nodiscard]] Result<BufferHandle> reserveBuffer(std::string_view label, std::size_t bytes) override {
        return device_.reserveBuffer(label, bytes);
    }
    void writeBuffer(BufferHandle buffer, std::size_t offset, std::span<const std::byte> bytes) override {
        device_.writeBuffer(buffer, offset, bytes);
    }
    void refillBuffer(std::string_view label, BufferHandle buffer) override {
        device_.refillBuffer(label, buffer);
    }
    [[nodiscard]] Result<BufferHandle> createScratch(std::string_view label, std::size_t bytes) override {
        return device_.createScratch(label, bytes);
    }
    void destroyBuffer(BufferHandle buffer) override { device_.destroyBuffer(buffer); }
    [[nodiscard]] Result<TextureHandle> createTexels(std::string_view label, BufferHandle buffer) override {
        return device_.createTexels(label, buffer);
    }
    [[nodiscard]] Result<TextureHandle> createTexture(std::string_view label,
                                                      const TextureShape& shape) override {
        return device_.createTexture(label, shape);
    }
    void writeTexture(TextureHandle texture, const TextureRows& rows,
                      std::span<const std::uint8_t> rgba) override {
        device_.writeTexture(texture, rows, rgba);
    }
    [[nodiscard]] std::uint64_t residentHandle(TextureHandle texture) override {
        return device_.residentHandle(texture);
    }
    void releaseHandle(TextureHandle texture) override { device_.releaseHandle(texture); }
    void destroyTexture(TextureHandle texture) override { device_.destroyTexture(texture); }
    [[nodiscard]] Result<ProgramHandle> createProgram(const ProgramSource& source) override {
        return device_.createProgram(source);
    }
    void destroyProgram(ProgramHandle program) override { device_.destroyProgram(program); }
    [[nodiscard]] Result<TargetHandle> createTarget(std::uint32_t width, std::uint32_t height,
                                                    const TargetOptions& options) override {
        return device_.createTarget(width, height, options);
    }
    [[nodiscard]] std::vector<glm::vec2> samplePositions(TargetHandle target) override {
        return device_.samplePositions(target);
    }
    void destroyTarget(TargetHandle target) override { device_.destroyTarget(target); }
    void readTarget(TargetHandle target, TargetImage image, std::span<std::byte> out) override {
        device_.readTarget(target, image, out);
    }
    void finishFrames() override { device_.finishFrames(); }
    void setGeometry(BufferHandle vertices, BufferHandle indices) override {
        device_.setGeometry(vertices, indices);
    }
    void setCulling(bool backFaces) override { device_.setCulling(backFaces); }
    [[nodiscard]] Result<void> reserveRing(std::size_t bytes) override { return device_.reserveRing(bytes); }
    [[nodiscard]] std::span<std::byte> beginFrame(TargetHandle target, const Viewport& viewport) override {
        return device_.beginFrame(target, viewport);
    }
    void bindStorage(std::span<const StorageRange> ranges) override { device_.bindStorage(ranges); }
    void bindTextures(std::span<const TextureHandle> textures, bool withDrawn) override {
        device_.bindTextures(textures, withDrawn);
    }
    [[nodiscard]] std::uint32_t baseInstanceAt(std::size_t offset) const override {
        return device_.baseInstanceAt(offset);
    }
    void readDrawn() override { device_.readDrawn(); }
    void compute(ProgramHandle program, const WorkGroups& groups) override {
        device_.compute(program, groups);
    }
    void clear(TargetImage image, const ClearValue& value) override { device_.clear(image, value); }
    void clearPicture(const glm::vec4& colour) override { device_.clearPicture(colour); }
    void flush() override { device_.flush(); }
    void beginStage(frame::StageKind stage) override { device_.beginStage(stage); }
    void endStage(frame::StageKind stage) override { device_.endStage(stage); }
    void beginPass(Pass pass) override { device_.beginPass(pass); }
    void setState(const DrawState& state) override { device_.setState(state); }
    void drawVertices(std::uint32_t first, std::uint32_t count) override {
        device_.drawVertices(first, count);
    }
    void drawIndirect(std::size_t offset, std::uint32_t count) override {
        device_.drawIndirect(offset, count);
    }
    void resolve() override { device_.resolve(); }
    [[nodiscard]] Result<void> endFrame() override { return device_.endFrame(); }
    [[nodiscard]] std::uint32_t glCalls() const override { return device_.glCalls(); }
    [[nodiscard]] std::uint32_t ringStalls() const override { return device_.ringStalls(); }
    [[nodiscard]] StageTimes stageTimes() override { return device_.stageTimes(); }
    [[nodiscard]] DeviceObjects objects() const override { return device_.objects(); }

protected:
    [[nodiscard]] Device& device() { return device_; }

private:
    Device& device_;
};

} // namespace limen::gpu
