#include "world/texture/Textures.h"

#include "world/records/Records.h"

#include "support/LoadTestWorld.h"

#include <gmock/gmock.h>
#include <turbojpeg.h>

namespace limen::world {
namespace {

using dat::PixelFormat;
using testing::ElementsAre;
using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

dat::RenderSurface picture(std::int32_t width, std::int32_t height, PixelFormat format, Bytes pixels) {
    dat::RenderSurface surface;
    surface.width = width;
    surface.height = height;
    surface.format = format;
    surface.pixels = std::move(pixels);
    return surface;
}

Bytes decodeOne(PixelFormat format, Bytes pixels, DecodeRules rules = {},
                const dat::Palette* palette = nullptr) {
    const Result<Image> image = decodeImage(picture(1, 1, format, std::move(pixels)), palette, rules);
    return image ? image->rgba : Bytes{};
}

TEST(DecodeImage, readsEveryPlainFormat) {
    EXPECT_THAT(decodeOne(PixelFormat::R8G8B8, {1, 2, 3}), ElementsAre(3, 2, 1, 255));
    EXPECT_THAT(decodeOne(PixelFormat::LandscapeR8G8B8, {1, 2, 3}), ElementsAre(3, 2, 1, 255));
    EXPECT_THAT(decodeOne(PixelFormat::A8R8G8B8, {1, 2, 3, 4}), ElementsAre(3, 2, 1, 4));
    EXPECT_THAT(decodeOne(PixelFormat::X8R8G8B8, {1, 2, 3, 4}), ElementsAre(3, 2, 1, 255));
    EXPECT_THAT(decodeOne(PixelFormat::R5G6B5, {0x00, 0xF8}), ElementsAre(255, 0, 0, 255));
    EXPECT_THAT(decodeOne(PixelFormat::R5G6B5, {0xE0, 0x07}), ElementsAre(0, 255, 0, 255));
    EXPECT_THAT(decodeOne(PixelFormat::R5G6B5, {0x10, 0x00}), ElementsAre(0, 0, 132, 255));
    EXPECT_THAT(decodeOne(PixelFormat::X1R5G5B5, {0x1F, 0x7C}), ElementsAre(255, 0, 255, 255));
    EXPECT_THAT(decodeOne(PixelFormat::A1R5G5B5, {0xE0, 0x83}), ElementsAre(0, 255, 0, 255));
    EXPECT_THAT(decodeOne(PixelFormat::A1R5G5B5, {0x10, 0x00}), ElementsAre(0, 0, 132, 0));
    EXPECT_THAT(decodeOne(PixelFormat::A4R4G4B4, {0x34, 0x12}), ElementsAre(0x22, 0x33, 0x44, 0x11));
    EXPECT_THAT(decodeOne(PixelFormat::L8, {9}), ElementsAre(9, 9, 9, 255));
    EXPECT_THAT(decodeOne(PixelFormat::LandscapeAlpha, {9}), ElementsAre(9, 9, 9, 9));
    EXPECT_THAT(decodeOne(PixelFormat::A8, {9}), ElementsAre(255, 255, 255, 9));
    EXPECT_THAT(decodeOne(PixelFormat::A8, {9}, {false, true}), ElementsAre(9, 9, 9, 9));
}

TEST(DecodeImage, readsPalettesAndTheirTransparentIndices) {
    dat::Palette palette;
    for (std::uint32_t i = 0; i < 256; ++i)
        palette.colours.push_back({0xFF000000u | i << 16 | 0x0203u});
    EXPECT_THAT(decodeOne(PixelFormat::P8, {7}, {}, &palette), ElementsAre(7, 2, 3, 255));
    EXPECT_THAT(decodeOne(PixelFormat::P8, {7}, {true, false}, &palette), ElementsAre(0, 0, 0, 0));
    EXPECT_THAT(decodeOne(PixelFormat::P8, {8}, {true, false}, &palette), ElementsAre(8, 2, 3, 255));
    EXPECT_THAT(decodeOne(PixelFormat::Index16, {0x10, 0}, {}, &palette), ElementsAre(16, 2, 3, 255));
    EXPECT_THAT(decodeOne(PixelFormat::Index16, {0xFF, 0xFF}, {}, &palette), ElementsAre(255, 2, 3, 255))
        << "clamped";
    EXPECT_THAT(decodeOne(PixelFormat::P8, {7}), testing::IsEmpty()) << "no palette";
}

TEST(DecodeImage, readsDxt1) {
    // Colours red and blue; row 0 has indices 0 1 2 3, the rest 0.
    const Bytes fourColours{0x00, 0xF8, 0x1F, 0x00, 0xE4, 0, 0, 0};
    const auto image = decodeImage(picture(4, 4, PixelFormat::Dxt1, fourColours), nullptr, {});
    ASSERT_TRUE(image);
    EXPECT_THAT(Bytes(image->rgba.begin(), image->rgba.begin() + 16),
                ElementsAre(255, 0, 0, 255, 0, 0, 255, 255, 170, 0, 85, 255, 85, 0, 170, 255));
    EXPECT_FALSE(image->hasAlpha);
    const Bytes punchThrough{0x1F, 0x00, 0x00, 0xF8, 0xE4, 0, 0, 0};
    const auto holes = decodeImage(picture(4, 4, PixelFormat::Dxt1, punchThrough), nullptr, {});
    ASSERT_TRUE(holes);
    EXPECT_THAT(Bytes(holes->rgba.begin() + 8, holes->rgba.begin() + 16),
                ElementsAre(127, 0, 127, 255, 0, 0, 0, 0));
    EXPECT_TRUE(holes->hasAlpha);
}

TEST(DecodeImage, readsDxt3AndDxt5Alpha) {
    Bytes dxt3{0x10, 0x32, 0, 0, 0, 0, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF, 0, 0, 0, 0};
    auto image = decodeImage(picture(4, 4, PixelFormat::Dxt3, dxt3), nullptr, {});
    ASSERT_TRUE(image);
    EXPECT_EQ(image->rgba[3], 0);
    EXPECT_EQ(image->rgba[7], 17);
    EXPECT_EQ(image->rgba[11], 34);
    EXPECT_EQ(image->rgba[15], 51);
    // Alphas 255 and 0 with eight steps; texel 0 index 0, texel 1 index 1, texel 2 index 2.
    Bytes dxt5{255, 0, 0x88, 0, 0, 0, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF, 0, 0, 0, 0};
    image = decodeImage(picture(4, 4, PixelFormat::Dxt5, dxt5), nullptr, {});
    ASSERT_TRUE(image);
    EXPECT_EQ(image->rgba[3], 255);
    EXPECT_EQ(image->rgba[7], 0);
    EXPECT_EQ(image->rgba[11], 218);
    Bytes six{0, 255, 0xC6, 0, 0, 0, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF, 0, 0, 0, 0}; // indices 6, 0, 3
    image = decodeImage(picture(4, 4, PixelFormat::Dxt5, six), nullptr, {});
    ASSERT_TRUE(image);
    EXPECT_EQ(image->rgba[3], 0);
    EXPECT_EQ(image->rgba[11], 102);
}

/// A JFIF file of two halves, red above blue.
Bytes jpegOf(int width, int height) {
    Bytes rgb;
    for (int i = 0; i < width * height; ++i)
        for (const int channel : {0, 1, 2})
            rgb.push_back(channel == (i < width * height / 2 ? 0 : 2) ? 255 : 0);
    const tjhandle encoder = tjInitCompress();
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    EXPECT_EQ(tjCompress2(encoder, rgb.data(), width, 0, height, TJPF_RGB, &bytes, &size, TJSAMP_444, 95, 0),
              0);
    Bytes out(bytes, bytes + size);
    tjFree(bytes);
    tjDestroy(encoder);
    return out;
}

TEST(DecodeImage, readsJpegsOfTheSizeTheySayThemselves) {
    const auto image = decodeImage(picture(-7, 0, PixelFormat::RawJpeg, jpegOf(16, 32)), nullptr, {});
    ASSERT_TRUE(image) << image.error().message();
    EXPECT_EQ(image->width, 16u);
    EXPECT_EQ(image->height, 32u);
    ASSERT_EQ(image->rgba.size(), 16u * 32u * 4u);
    EXPECT_FALSE(image->hasAlpha);
    EXPECT_NEAR(image->rgba[0], 255, 3) << "red on top";
    EXPECT_NEAR(image->rgba[2], 0, 3);
    EXPECT_NEAR(image->rgba[image->rgba.size() - 2], 255, 3);
    EXPECT_EQ(image->rgba[3], 255);
}

TEST(DecodeImage, refusesJpegsThatBreakOffOrAreTooLarge) {
    Bytes cut = jpegOf(64, 64);
    cut.resize(cut.size() / 2);
    EXPECT_FALSE(decodeImage(picture(64, 64, PixelFormat::RawJpeg, cut), nullptr, {}));
    EXPECT_FALSE(decodeImage(picture(1, 1, PixelFormat::RawJpeg, jpegOf(4104, 1)), nullptr, {}));
    EXPECT_FALSE(decodeImage(picture(1, 1, PixelFormat::RawJpeg, {}), nullptr, {}));
}

TEST(DecodeImage, keepsBlackOfDxtClipMapsAndHandlesOddSizes) {
    const auto opaque = decodeImage(picture(3, 2, PixelFormat::Dxt1, {1, 0, 0, 0, 0x55, 0x55, 0x55, 0x55}),
                                    nullptr, {true, false});
    ASSERT_TRUE(opaque);
    for (std::size_t i = 0; i < 24; ++i)
        EXPECT_EQ(opaque->rgba[i], i % 4 == 3 ? 255 : 0) << "black by itself is not transparent";
}

TEST(DecodeImage, notesWhetherTexelsWereIndices) {
    dat::Palette palette;
    palette.colours.resize(256);
    EXPECT_TRUE(decodeImage(picture(1, 1, PixelFormat::P8, {9}), &palette, {true, false})->isIndexed);
    EXPECT_TRUE(decodeImage(picture(1, 1, PixelFormat::Index16, {9, 0}), &palette, {})->isIndexed);
    EXPECT_FALSE(decodeImage(picture(1, 1, PixelFormat::A8, {9}), nullptr, {})->isIndexed);
}

TEST(DecodeImage, indicesBelow8OfClipMapsAreTransparent) {
    dat::Palette palette;
    palette.colours.assign(256, {0xFF102030u});
    for (const std::uint8_t index : std::array<std::uint8_t, 4>{0, 7, 8, 255}) {
        EXPECT_EQ(decodeImage(picture(1, 1, PixelFormat::P8, {index}), &palette, {true, false})->rgba[3],
                  index < 8 ? 0 : 255);
        EXPECT_EQ(decodeImage(picture(1, 1, PixelFormat::P8, {index}), &palette, {})->rgba[3], 255);
    }
}

TEST(DecodeImage, refusesSizesThatDoNotFit) {
    const auto errorOf = [](const dat::RenderSurface& surface) {
        const Result<Image> image = decodeImage(surface, nullptr, {});
        return image ? ErrorCode::NotFound : image.error().code;
    };
    EXPECT_EQ(errorOf(picture(2, 2, PixelFormat::A8, {1, 2, 3})), ErrorCode::Malformed);
    EXPECT_EQ(errorOf(picture(0, 2, PixelFormat::A8, {})), ErrorCode::Malformed);
    EXPECT_EQ(errorOf(picture(-1, 2, PixelFormat::A8, {})), ErrorCode::Malformed);
    EXPECT_EQ(errorOf(picture(100000, 100000, PixelFormat::A8, {})), ErrorCode::Malformed);
    EXPECT_EQ(errorOf(picture(4, 4, PixelFormat::Dxt5, Bytes(8))), ErrorCode::Malformed);
    EXPECT_EQ(errorOf(picture(4, 4, PixelFormat::RawJpeg, Bytes(8))), ErrorCode::Malformed);
    EXPECT_EQ(errorOf(picture(4, 4, static_cast<PixelFormat>(77), Bytes(8))), ErrorCode::Unsupported);
}

TEST(BleedColour, fillsTransparentTexelsFromTheirNeighboursAndKeepsAlpha) {
    Image image{3, 1, {10, 20, 30, 255, 0, 0, 0, 0, 30, 40, 50, 255}, true};
    bleedColour(image);
    EXPECT_THAT(Bytes(image.rgba.begin() + 4, image.rgba.begin() + 8), ElementsAre(20, 30, 40, 0));
    EXPECT_THAT(Bytes(image.rgba.begin(), image.rgba.begin() + 4), ElementsAre(10, 20, 30, 255));
}

const Material& materialOf(const World& world, dat::RecordId surface) {
    const auto found = std::find_if(world.materials.begin(), world.materials.end(),
                                    [&](const Material& m) { return m.surface == surface; });
    static const Material none;
    return found == world.materials.end() ? none : *found;
}

TEST(Materials, followTheSurfacesBits) {
    test::TestWorld source;
    using S = dat::Surface;
    const dat::RenderSurface image = test::solidImage(4, 4, 0xFF336699);
    const auto opaque = source.picture("opaque", image, S::kBase1Image);
    const auto cut = source.picture("cut", image, S::kBase1ClipMap);
    const auto additive = source.picture("additive", image, S::kBase1Image | S::kAdditive);
    const auto alpha = source.picture("alpha", image, S::kBase1Image | S::kAlpha);
    const auto glass = source.plain("glass", 0xFF0000FF, S::kTranslucent, 0.25f);
    test::Walls walls = test::boxWalls({0, 0, 0}, {4, 4, 3});
    const char* names[] = {"opaque", "cut", "additive", "alpha", "glass", "missing"};
    for (std::size_t i = 0; i < 6; ++i)
        walls[i].surface = names[i];
    const auto cell = source.addCell(walls);
    static_cast<void>(cell);
    const World world = test::loadTestWorld(source);
    EXPECT_EQ(materialOf(world, opaque).surfaceClass, SurfaceClass::Opaque);
    EXPECT_EQ(materialOf(world, cut).surfaceClass, SurfaceClass::CutOut);
    EXPECT_EQ(materialOf(world, additive).surfaceClass, SurfaceClass::Blended);
    EXPECT_EQ(materialOf(world, additive).flags, Material::kAdditive);
    EXPECT_EQ(materialOf(world, alpha).flags, Material::kAlpha | Material::kSplit);
    EXPECT_EQ(materialOf(world, glass).surfaceClass, SurfaceClass::Blended);
    EXPECT_EQ(materialOf(world, glass).colour, Vec4f(0, 0, 1, 0.75f));
    EXPECT_EQ(materialOf(world, glass).texture, kNone);
    const Mesh& shell = world.meshes[world.instances[world.spaces[1].shell].mesh];
    EXPECT_EQ(shell.ranges[0].indexCount, 12u) << "opaque, and the solid colour";
    EXPECT_EQ(shell.ranges[1].indexCount, 6u);
    EXPECT_EQ(shell.ranges[2].indexCount, 12u) << "the glass has no picture";
    EXPECT_EQ(shell.splitIndexCount, 6u);
    EXPECT_EQ(shell.ranges[2].firstIndex, shell.ranges[1].firstIndex + 6)
        << "split triangles follow the cut-outs";
    const MeshVertex& first = world.vertices[shell.firstVertex + world.indices[shell.ranges[2].firstIndex]];
    EXPECT_EQ(first.surface, 3u)
        << "split triangles come first among the blended ones, although not in the record";
}

TEST(Materials, shineByTheirLuminosity_whateverTheirFlags) {
    test::TestWorld source;
    using S = dat::Surface;
    const auto plain = source.luminous("plain", 0.8f, 0.25f, 0);
    const auto flagged = source.luminous("flagged", 0.8f, 0.25f, S::kLuminous | S::kDiffuse);
    test::Walls walls = test::boxWalls({0, 0, 0}, {4, 4, 3});
    walls[0].surface = "plain";
    walls[1].surface = "flagged";
    static_cast<void>(source.addCell(walls));
    const World world = test::loadTestWorld(source);
    EXPECT_EQ(materialOf(world, plain).luminosity, 0.8f);
    EXPECT_EQ(materialOf(world, flagged).luminosity, 0.8f);
    EXPECT_EQ(materialOf(world, plain).diffuse, 0.25f) << "it counts by a reading alone";
}

TEST(Materials, areTranslucentAboveAFiveThousandth) {
    using S = dat::Surface;
    S surface;
    surface.type = S::kBase1Image;
    surface.translucency = 0.0002f;
    EXPECT_EQ(surfaceClassOf(surface), SurfaceClass::Opaque);
    EXPECT_EQ(alphaOf(surface), 1.0f);
    surface.translucency = 0.00021f;
    EXPECT_EQ(surfaceClassOf(surface), SurfaceClass::Blended);
    EXPECT_FLOAT_EQ(alphaOf(surface), 1.0f - 0.00021f);
    surface.translucency = 1.0f;
    EXPECT_EQ(alphaOf(surface), 0.0f);
    EXPECT_EQ(surfaceClassOf(surface), SurfaceClass::Blended);
}

TEST(Materials, knowWhetherTheirPicturesHavePalettes) {
    test::TestWorld source;
    dat::Palette palette;
    palette.id = 0x04000001;
    palette.colours.assign(256, {0xFF102030u});
    source.portalFile().add(palette);
    dat::RenderSurface indexed = test::solidImage(2, 2, 0);
    indexed.format = PixelFormat::P8;
    indexed.pixels = {9, 9, 9, 9};
    indexed.defaultPalette = palette.id;
    const auto leaves = source.picture("leaves", indexed, dat::Surface::kBase1ClipMap),
               grass =
                   source.picture("grass", test::solidImage(2, 2, 0xFF00FF00), dat::Surface::kBase1ClipMap);
    source.addBox({0, 0, 0}, {4, 4, 3}, "leaves");
    source.addBox({5, 0, 0}, {9, 4, 3}, "grass");
    const World world = test::loadTestWorld(source);
    EXPECT_EQ(materialOf(world, leaves).flags, Material::kIndexed);
    EXPECT_EQ(materialOf(world, grass).flags, 0u);
}

TEST(Materials, areSplitIfTheirPicturesAlphaAloneBlendsThem) {
    using S = dat::Surface;
    S surface;
    surface.type = S::kBase1Image | S::kAlpha;
    EXPECT_TRUE(isSplit(surface));
    surface.translucency = 0.5f;
    EXPECT_FALSE(isSplit(surface)) << "nowhere nearly opaque";
    surface.translucency = 0.0f;
    for (const std::uint32_t other : {S::kAdditive, S::kInvAlpha}) {
        surface.type = S::kBase1Image | S::kAlpha | other;
        EXPECT_FALSE(isSplit(surface));
    }
    surface.type = S::kBase1Image;
    EXPECT_FALSE(isSplit(surface)) << "opaque at every alpha of its picture";
    surface.type = S::kBase1Solid | S::kAlpha;
    EXPECT_FALSE(isSplit(surface)) << "no picture";
}

TEST(Materials, fallBackToGreyAndSaySo) {
    test::TestWorld source;
    dat::RenderSurface jpeg = test::solidImage(4, 4, 0);
    jpeg.format = PixelFormat::RawJpeg; // its bytes are not a JPEG file
    const auto surface = source.picture("jpeg", jpeg, dat::Surface::kBase1Image);
    source.addBox({0, 0, 0}, {4, 4, 3}, "jpeg");
    const World world = test::loadTestWorld(source);
    ASSERT_NE(materialOf(world, surface).texture, kNone);
    EXPECT_EQ(world.textures[materialOf(world, surface).texture]->rgba[0], 128);
    EXPECT_THAT(test::findingsOf(world), HasSubstr("JPEG picture"));
}

TEST(Materials, takeTheFirstPictureThatExists) {
    for (const bool isFirstThere : {true, false}) {
        test::TestWorld source;
        const std::uint32_t texture = source.nextTexture();
        const auto surface =
            source.picture("two", test::solidImage(8, 8, 0xFF112233), dat::Surface::kBase1Image);
        dat::SurfaceTexture record;
        record.id = texture;
        record.images = {isFirstThere ? 0x06000100u : 0x06000999u, 0x06000001}; // of 8 and of 4 texels
        source.portalFile().add(record);
        source.addBox({0, 0, 0}, {4, 4, 3}, "two");
        const World world = test::loadTestWorld(source);
        ASSERT_NE(materialOf(world, surface).texture, kNone);
        EXPECT_EQ(world.textures[materialOf(world, surface).texture]->width, isFirstThere ? 8u : 4u);
    }
}

TEST(Materials, decodeAPictureOnceHoweverManySurfacesUseIt) {
    test::TestWorld source;
    source.picture("one", test::solidImage(4, 4, 0xFF112233), dat::Surface::kBase1Image);
    for (int i = 0; i < 5; ++i)
        source.addBox({i * 5.0, 0, 0}, {i * 5.0 + 4, 4, 3}, "one");
    const World world = test::loadTestWorld(source);
    EXPECT_EQ(world.textures.size(), 1u);
    EXPECT_EQ(std::count_if(world.materials.begin(), world.materials.end(),
                            [](const Material& m) { return m.texture != kNone; }),
              1);
}

} // namespace
} // namespace limen::world
