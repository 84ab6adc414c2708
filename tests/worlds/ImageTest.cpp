#include "worlds/pictures/Painters.h"
#include "worlds/records/Materials.h"
#include "worlds/records/PixelEncoder.h"

#include <gtest/gtest.h>

namespace limen::worlds {
namespace {

using dat::PixelFormat;

Canvas ramp() {
    return Canvas::paint(16, 8, [](double u, double v) {
        return Vec4f(static_cast<float>(u), static_cast<float>(v), 0.25f, u < 0.5 ? 0.0f : 1.0f);
    });
}

TEST(PixelEncoder, storesBlueFirst) {
    Canvas canvas(4, 4, Vec4f(1.0f, 0.0f, 0.0f, 0.5f));
    const std::vector<std::uint8_t> bytes = encodeImage(canvas, PixelFormat::A8R8G8B8).image.pixels;
    EXPECT_EQ((std::vector<std::uint8_t>(bytes.begin(), bytes.begin() + 4)),
              (std::vector<std::uint8_t>{0, 0, 255, 128}));
    EXPECT_EQ(encodeImage(canvas, PixelFormat::R8G8B8).image.pixels[2], 255);
    const auto high = encodeImage(canvas, PixelFormat::R5G6B5).image.pixels;
    EXPECT_EQ(high[0] | high[1] << 8, 0xF800);
    const auto nibbles = encodeImage(canvas, PixelFormat::A4R4G4B4).image.pixels;
    EXPECT_EQ(nibbles[0] | nibbles[1] << 8, 0x8F00);
}

TEST(PixelEncoder, givesEveryFormatItsSize) {
    const std::size_t texels = 16 * 8;
    for (const auto& [format, bytes] :
         {std::pair{PixelFormat::A8, texels}, std::pair{PixelFormat::LandscapeAlpha, texels},
          std::pair{PixelFormat::P8, texels}, std::pair{PixelFormat::Index16, 2 * texels},
          std::pair{PixelFormat::R8G8B8, 3 * texels}, std::pair{PixelFormat::LandscapeR8G8B8, 3 * texels},
          std::pair{PixelFormat::A8R8G8B8, 4 * texels}, std::pair{PixelFormat::Dxt1, texels / 2}})
        EXPECT_EQ(encodeImage(ramp(), format).image.pixels.size(), bytes);
}

TEST(PixelEncoder, paletteKeepsTheFirstEightForClearTexels) {
    const EncodedImage encoded = encodeImage(ramp(), PixelFormat::P8);
    ASSERT_EQ(encoded.palette.colours.size(), 256u);
    for (int i = 0; i < 16 * 8; ++i) {
        const bool clear = i % 16 < 8;
        const std::uint8_t index = encoded.image.pixels[static_cast<std::size_t>(i)];
        EXPECT_EQ(index < 8, clear);
        if (!clear) {
            const std::uint32_t argb = encoded.palette.colours[index].argb;
            EXPECT_NEAR((argb >> 16) & 255, (i % 16 + 0.5) / 16.0 * 255.0, 9.0);
        }
    }
}

TEST(PixelEncoder, dxt1OfTwoColoursIsExactToItsFiveAndSixBits) {
    const Canvas canvas =
        Canvas::paint(4, 4, [](double u, double) { return u < 0.5 ? Vec4f(1, 1, 1, 1) : Vec4f(0, 0, 0, 1); });
    const auto bytes = encodeImage(canvas, PixelFormat::Dxt1).image.pixels;
    ASSERT_EQ(bytes.size(), 8u);
    const int c0 = bytes[0] | bytes[1] << 8;
    const int c1 = bytes[2] | bytes[3] << 8;
    EXPECT_GT(c0, c1) << "four-colour mode";
    for (std::size_t row = 4; row < 8; ++row)
        EXPECT_EQ(bytes[row], 0b01010000) << "two texels of colour 0, two of colour 1";
}

TEST(PixelEncoder, dxt1PunchesThroughClearTexels) {
    const Canvas canvas = Canvas::paint(4, 4, [](double u, double v) {
        return Vec4f(static_cast<float>(v), 0.5f, 0.5f, u < 0.5 ? 0.0f : 1.0f);
    });
    const auto bytes = encodeImage(canvas, PixelFormat::Dxt1).image.pixels;
    EXPECT_LE(bytes[0] | bytes[1] << 8, bytes[2] | bytes[3] << 8) << "three colours and clear";
    for (std::size_t row = 4; row < 8; ++row) {
        EXPECT_EQ(bytes[row] & 0x0F, 0x0F);
        EXPECT_NE(bytes[row] & 0x30, 0x30);
        EXPECT_NE(bytes[row] & 0xC0, 0xC0);
    }
}

TEST(Painters, blendMapsShowTheOverlayWhereTheirCodeSays) {
    // Alpha 0 shows the upper layer. Codes: corner 8 is north-west, side 9 west; north is the top row.
    const auto alpha = [](BlendShape shape, int x, int y) { return paintBlend(shape, 1).at(x, y).w; };
    EXPECT_LT(alpha(BlendShape::Corner, 0, 0), 0.05f);
    for (const auto& [x, y] : {std::pair{255, 0}, std::pair{0, 255}, std::pair{255, 255}})
        EXPECT_GT(alpha(BlendShape::Corner, x, y), 0.95f);
    EXPECT_LT(alpha(BlendShape::Side, 0, 0), 0.05f);
    EXPECT_LT(alpha(BlendShape::Side, 0, 255), 0.05f);
    EXPECT_GT(alpha(BlendShape::Side, 255, 128), 0.95f);
    EXPECT_LT(alpha(BlendShape::RoadDiagonal, 139, 117),
              0.05f); // a wheel track, 1.5 m from the grassy middle
    EXPECT_GT(alpha(BlendShape::RoadDiagonal, 255, 0), 0.95f);
}

TEST(Painters, cutOutsHaveBothHolesAndLeaves) {
    for (const Material material : {Material::Leaves, Material::BirchLeaves, Material::PineBranch,
                                    Material::GrassTuft, Material::Flowers}) {
        const Canvas canvas = paintMaterial(material);
        int solid = 0;
        for (int i = 0; i < canvas.width() * canvas.height(); ++i)
            solid += canvas.at(i % canvas.width(), i / canvas.width()).w >= 0.5f;
        const double share = static_cast<double>(solid) / (canvas.width() * canvas.height());
        EXPECT_GT(share, 0.12);
        EXPECT_LT(share, 0.8);
    }
}

} // namespace
} // namespace limen::worlds
