#include "gpu/texture/TextureStore.h"

#include "SceneBuilder.h"
#include "gpu/device/NullDevice.h"

#include <gtest/gtest.h>

namespace limen::gpu::test {
namespace {

SceneBuilder threeTextures() {
    SceneBuilder scene;
    scene.addTexture(2, 2, std::vector<std::uint8_t>(16), true);
    scene.addTexture(4, 2, std::vector<std::uint8_t>(32), false);
    scene.addTexture(2, 2, std::vector<std::uint8_t>(16), true);
    return scene;
}

TEST(TextureStore, arrayPages_shareSizesAndLocateEachTexture) {
    NullDevice device;
    SceneBuilder scene = threeTextures();
    {
        const Result<TextureStore> store = TextureStore::create(device, scene.upload.textures, {});
        ASSERT_TRUE(store);
        const std::vector<std::uint32_t> two{0, 2, layout::kNoTexture}, all{1, 0};
        EXPECT_EQ(store->bindingFor(two), (TextureBinding{false, 2, {0}}));
        EXPECT_EQ(store->bindingFor(all), (TextureBinding{false, 2, {0, 1}}));
        EXPECT_EQ(store->refs()[0].place, glm::uvec4(0, 0, 2 | layout::kTextureClamp, 2));
        EXPECT_EQ(store->refs()[1].place, glm::uvec4(0, 1, 4, 2));
        EXPECT_EQ(store->refs()[2].place, glm::uvec4(1, 0, 2 | layout::kTextureClamp, 2));
        EXPECT_EQ(device.textures()[0].levels, 2u);
        EXPECT_EQ(device.liveObjects(), 2u);
    }
    EXPECT_EQ(device.liveObjects(), 0u) << "the moved store owns its textures";
}

TEST(TextureStore, bindless_hasAHandleForEachAndBindsNoPage) {
    Capabilities capabilities = NullDevice::defaultCapabilities();
    capabilities.bindless = true;
    NullDevice device(capabilities);
    SceneBuilder scene = threeTextures();
    const Result<TextureStore> store = TextureStore::create(device, scene.upload.textures, {});
    ASSERT_TRUE(store);
    const std::vector<std::uint32_t> all{0, 1, 2};
    EXPECT_EQ(store->bindingFor(all), (TextureBinding{true, 0, {}}));
    EXPECT_TRUE(store->pages().empty());
    EXPECT_NE(store->refs()[0].place.x, store->refs()[2].place.x);
}

TEST(TextureStore, unsupportedTexturesAreRefusedAndLeaveNoObjects) {
    Capabilities capabilities = NullDevice::defaultCapabilities();
    capabilities.maxTextureSize = 3;
    NullDevice device(capabilities);
    SceneBuilder scene = threeTextures();
    EXPECT_FALSE(TextureStore::create(device, scene.upload.textures, {}));
    EXPECT_FALSE(TextureStore::create(device, scene.upload.textures, {.mode = TextureMode::Bindless}));
    EXPECT_EQ(device.liveObjects(), 0u);
}

TEST(TextureStore, softwareDriversFilterWithoutAnisotropy) {
    Capabilities capabilities = NullDevice::defaultCapabilities();
    capabilities.software = true;
    NullDevice device(capabilities);
    SceneBuilder scene = threeTextures();
    ASSERT_TRUE(TextureStore::create(device, scene.upload.textures, {.anisotropy = 8.0f}));
    EXPECT_EQ(device.textures()[0].anisotropy, 1.0f);
}

} // namespace
} // namespace limen::gpu::test
