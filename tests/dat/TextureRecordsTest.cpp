#include "dat/Hex.h"

#include <gtest/gtest.h>

namespace limen::dat {
namespace {

TEST(PaletteCodec, readsCountAndColours) {
    const Bytes bytes = hex("01 00 00 04  02 00 00 00  33 22 11 FF  00 00 FF 80");
    const auto p = decode<Palette>(0x04000001, bytes);
    ASSERT_TRUE(p) << p.error().message();
    EXPECT_EQ(p->id, 0x04000001u);
    ASSERT_EQ(p->colours.size(), 2u);
    EXPECT_EQ(p->colours[0].argb, 0xFF112233u);
    EXPECT_EQ(p->colours[1].argb, 0x80FF0000u);
    EXPECT_EQ(*encode(*p), bytes);
}

TEST(PaletteCodec, refusesANegativeCountAndOneBeyondTheBytes) {
    const auto negative = decode<Palette>(0x04000001, hex("01 00 00 04  FF FF FF FF"));
    ASSERT_FALSE(negative);
    EXPECT_EQ(negative.error().where, "record 0x04000001, offset 0x4");
    EXPECT_EQ(negative.error().what, "the number of colours is negative (-1)");
    const auto huge = decode<Palette>(0x04000001, hex("01 00 00 04  FF FF FF 7F  00 00 00 00"));
    ASSERT_FALSE(huge);
    EXPECT_EQ(huge.error().what, "the record has 2147483647 colours by its count, but only 4 bytes follow");
}

TEST(SurfaceTextureCodec, readsTheOneByteTypeAndTheImages) {
    const Bytes bytes = hex("9A 1A 00 05  00 00 00 00  02  02 00 00 00  34 12 00 06  35 12 00 06");
    const auto s = decode<SurfaceTexture>(0x05001A9A, bytes);
    ASSERT_TRUE(s) << s.error().message();
    EXPECT_EQ(s->type, 2);
    EXPECT_EQ(s->images, (std::vector<std::uint32_t>{0x06001234, 0x06001235}));
    EXPECT_EQ(*encode(*s), bytes);
}

TEST(RenderSurfaceCodec, readsPixelsWithoutAPalette) {
    const Bytes bytes = hex("01 00 00 06  00 00 00 00  02 00 00 00  01 00 00 00  15 00 00 00  08 00 00 00"
                            "01 02 03 FF  04 05 06 7F");
    const auto s = decode<RenderSurface>(0x06000001, bytes);
    ASSERT_TRUE(s) << s.error().message();
    EXPECT_EQ(s->width, 2);
    EXPECT_EQ(s->height, 1);
    EXPECT_EQ(s->format, PixelFormat::A8R8G8B8);
    EXPECT_EQ(s->pixels.size(), 8u);
    EXPECT_EQ(s->pixels[7], 0x7F);
    EXPECT_EQ(*encode(*s), bytes);
}

TEST(RenderSurfaceCodec, indexedFormatsEndWithAPalette) {
    for (const char* format : {"29 00 00 00  02 00 00 00  05 06", "65 00 00 00  04 00 00 00  05 00 06 00"}) {
        const Bytes bytes =
            hex(std::string("01 00 00 06  07 00 00 00  02 00 00 00  01 00 00 00 ") + format + "7B 00 00 04");
        const auto s = decode<RenderSurface>(0x06000001, bytes);
        ASSERT_TRUE(s) << s.error().message();
        EXPECT_EQ(s->category, 7u);
        EXPECT_EQ(s->defaultPalette, 0x0400007Bu);
        EXPECT_EQ(*encode(*s), bytes);
    }
}

TEST(RenderSurfaceCodec, compressedFormatsCountBlocks) {
    // 5x3 texels are 2x1 blocks: 16 bytes of DXT1, 32 of DXT5.
    const std::string size = "01 00 00 06  00 00 00 00  05 00 00 00  03 00 00 00 ";
    const std::string sixteen = "00 11 22 33 44 55 66 77 88 99 AA BB CC DD EE FF ";
    EXPECT_TRUE(decode<RenderSurface>(0x06000001, hex(size + "44 58 54 31  10 00 00 00" + sixteen)));
    EXPECT_TRUE(
        decode<RenderSurface>(0x06000001, hex(size + "44 58 54 35  20 00 00 00" + sixteen + sixteen)));
    const auto wrong = decode<RenderSurface>(0x06000001, hex(size + "44 58 54 33  10 00 00 00" + sixteen));
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().what, "the image has 16 bytes; 5x3 texels of format 0x33545844 take 32");
}

TEST(RenderSurfaceCodec, aRawJpegKnowsItsOwnSize) {
    const Bytes bytes =
        hex("01 00 00 06  00 00 00 00  FF FF FF FF  00 00 00 00  F4 01 00 00  03 00 00 00  FF D8 FF");
    const auto s = decode<RenderSurface>(0x06000001, bytes);
    ASSERT_TRUE(s) << s.error().message();
    EXPECT_EQ(s->width, -1);
    EXPECT_EQ(*encode(*s), bytes);
}

TEST(RenderSurfaceCodec, refusesAbsurdSizesAndUnknownFormats) {
    const auto large = decode<RenderSurface>(
        0x06000001, hex("01 00 00 06  00 00 00 00  01 10 00 00  01 00 00 00  1C 00 00 00  01 00 00 00  00"));
    ASSERT_FALSE(large);
    EXPECT_EQ(large.error().what, "the image has 4097 x 1 texels; each side may have 0 to 4096");
    const auto unknown = decode<RenderSurface>(
        0x06000001, hex("01 00 00 06  00 00 00 00  01 00 00 00  01 00 00 00  3C 00 00 00  01 00 00 00  00"));
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().code, ErrorCode::Unsupported);
}

// The two records with values that the format page quotes from end-of-retail files.
TEST(SurfaceCodec, readsTheQuotedImageSurface) {
    const Bytes bytes = hex("02 00 00 00  9A 1A 00 05  00 00 00 00  00 00 00 00  00 00 00 00  00 00 4D 3F");
    const auto s = decode<Surface>(0x08000DCB, bytes);
    ASSERT_TRUE(s) << s.error().message();
    EXPECT_EQ(s->type, Surface::kBase1Image);
    EXPECT_EQ(s->texture, 0x05001A9Au);
    EXPECT_EQ(s->palette, 0u);
    EXPECT_FLOAT_EQ(s->diffuse, 0.80078125f);
    EXPECT_EQ(bytes.size(), 24u);
    EXPECT_EQ(*encode(*s), bytes);
}

TEST(SurfaceCodec, readsTheQuotedSolidSurface) {
    const Bytes bytes = hex("01 00 00 00  16 39 6F FF  00 00 00 00  00 00 00 00  00 00 80 3F");
    const auto s = decode<Surface>(0x08000219, bytes);
    ASSERT_TRUE(s) << s.error().message();
    EXPECT_FALSE(s->hasImage());
    EXPECT_EQ(s->colour.argb, 0xFF6F3916u);
    EXPECT_EQ(s->diffuse, 1.0f);
    EXPECT_EQ(bytes.size(), 20u);
    EXPECT_EQ(*encode(*s), bytes);
}

} // namespace
} // namespace limen::dat
