#pragma once

#include "SceneBuilder.h"
#include "gpu/Renderer.h"
#include "gpu/device/DebugOutput.h"
#include "gpu/device/GlDevice.h"
#include "gpu/device/HeadlessContext.h"

#include <gtest/gtest.h>

namespace limen::gpu::test {

/// Images of a frame.
struct Frame {
    std::vector<std::uint32_t> ids, ownership;
    std::vector<std::uint8_t> colour;
    std::vector<float> depth;
    std::vector<LayerSum> layers{}; ///< if requested
    std::uint32_t width = 0;

    [[nodiscard]] std::vector<std::string> picture() const { return test::picture(ids, width); }
    /// R,G,B of a pixel, 0..255.
    [[nodiscard]] glm::ivec3 at(std::uint32_t x, std::uint32_t y) const {
        const std::size_t i = (std::size_t{y} * width + x) * 4;
        return {colour[i], colour[i + 1], colour[i + 2]};
    }
};

/// Headless debug context and a device on it. An error or a message of high severity fails the test.
class GlTest : public ::testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

    /// Uploads and draws the scene, size x size pixels.
    Frame render(SceneBuilder& scene, std::uint32_t size = 8, const RendererOptions& options = {});
    Frame renderWith(Renderer& renderer, const frame::FramePlan& plan, std::uint32_t width,
                     std::uint32_t height, const RenderOptions& options = {});

    std::optional<HeadlessContext> context_;
    std::optional<DebugOutput> debug_;
    std::unique_ptr<GlDevice> device_;
};

} // namespace limen::gpu::test
