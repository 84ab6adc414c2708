#include "output/Encode.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>
#include <png.h>
#include <turbojpeg.h>
#include <webp/decode.h>

namespace limen::output {
namespace {

Picture readPng(const std::vector<std::byte>& bytes) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()), 0);
    image.format = PNG_FORMAT_RGB;
    Picture picture(image.width, image.height);
    EXPECT_NE(png_image_finish_read(&image, nullptr, picture.rgb.data(), 0, nullptr), 0);
    return picture;
}

const unsigned char* dataOf(const std::vector<std::byte>& bytes) {
    return reinterpret_cast<const unsigned char*>(bytes.data());
}

Picture readJpeg(const std::vector<std::byte>& bytes) {
    const std::unique_ptr<void, int (*)(tjhandle)> decoder(tjInitDecompress(), &tjDestroy);
    int width = 0, height = 0, sampling = 0, space = 0;
    EXPECT_EQ(
        tjDecompressHeader3(decoder.get(), dataOf(bytes), bytes.size(), &width, &height, &sampling, &space),
        0);
    EXPECT_EQ(sampling, TJSAMP_444);
    Picture picture(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height));
    EXPECT_EQ(tjDecompress2(decoder.get(), dataOf(bytes), bytes.size(), picture.rgb.data(), width, 0, height,
                            TJPF_RGB, 0),
              0);
    return picture;
}

Picture readWebp(const std::vector<std::byte>& bytes) {
    int width = 0, height = 0;
    const std::unique_ptr<std::uint8_t, void (*)(void*)> pixels(
        WebPDecodeRGB(dataOf(bytes), bytes.size(), &width, &height), &WebPFree);
    EXPECT_TRUE(pixels);
    Picture picture(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height));
    if (pixels)
        std::copy_n(pixels.get(), picture.rgb.size(), picture.rgb.begin());
    return picture;
}

/// Smooth colours, as lossy formats keep them well; no symmetry, so that swapped axes or channels differ.
Picture gradient() {
    Picture picture(48, 32);
    for (std::uint32_t y = 0; y < 32; ++y)
        for (std::uint32_t x = 0; x < 48; ++x)
            picture.set(x, y, {static_cast<std::uint8_t>(5 * x), static_cast<std::uint8_t>(7 * y), 60});
    return picture;
}

double meanDifference(const Picture& a, const Picture& b) {
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    double sum = 0.0;
    for (std::size_t i = 0; i < std::min(a.rgb.size(), b.rgb.size()); ++i)
        sum += std::abs(a.rgb[i] - b.rgb[i]);
    return sum / static_cast<double>(a.rgb.size());
}

TEST(Encode, pngReadsBackPixelForPixel) {
    Picture picture(5, 3);
    for (std::size_t i = 0; i < picture.rgb.size(); ++i)
        picture.rgb[i] = static_cast<std::uint8_t>(i * 37);
    const auto png = encodePng(picture);
    ASSERT_TRUE(png);
    const Picture read = readPng(*png);
    EXPECT_EQ(read.width, 5u);
    EXPECT_EQ(read.height, 3u);
    EXPECT_EQ(read.rgb, picture.rgb);
}

TEST(Encode, jpegAndWebpReadBackNearly) {
    const auto jpeg = encodeJpeg(gradient());
    ASSERT_TRUE(jpeg) << jpeg.error().message();
    EXPECT_LT(meanDifference(readJpeg(*jpeg), gradient()), 3.0);
    const auto webp = encodeWebp(gradient());
    ASSERT_TRUE(webp) << webp.error().message();
    EXPECT_LT(meanDifference(readWebp(*webp), gradient()), 6.0);
    EXPECT_LT(encodeJpeg(gradient(), 20)->size(), jpeg->size());
    EXPECT_LT(encodeWebp(gradient(), 20)->size(), webp->size());
}

TEST(Encode, aPictureWithoutPixelsOrTooWideIsRefused) {
    for (const PictureFormat format : {PictureFormat::Png, PictureFormat::Jpeg, PictureFormat::Webp})
        EXPECT_FALSE(encodePicture(Picture{}, format));
    const auto webp = encodeWebp(Picture(16384, 1));
    ASSERT_FALSE(webp);
    EXPECT_THAT(webp.error().message(), testing::HasSubstr("16383"));
    EXPECT_TRUE(encodeWebp(Picture(16383, 1)));
    const auto jpeg = encodeJpeg(Picture(1, 65501));
    ASSERT_FALSE(jpeg);
    EXPECT_THAT(jpeg.error().message(), testing::HasSubstr("65500"));
    EXPECT_TRUE(encodeJpeg(Picture(1, 65500)));
}

TEST(Encode, theEndingSelectsTheFormat) {
    EXPECT_EQ(pictureFormatOf("a/b.png").value(), PictureFormat::Png);
    EXPECT_EQ(pictureFormatOf("b.JPG").value(), PictureFormat::Jpeg);
    EXPECT_EQ(pictureFormatOf("b.x.jpeg").value(), PictureFormat::Jpeg);
    EXPECT_EQ(pictureFormatOf("b.webp").value(), PictureFormat::Webp);
    EXPECT_EQ(pictureFormatOf("/dev/null").value(), PictureFormat::Png);
    for (const char* name : {"", "picture", "a.png/b", "b.bmp", ".png"}) {
        const auto format = pictureFormatOf(name);
        ASSERT_FALSE(format) << name;
        EXPECT_EQ(format.error().where, name);
        for (const char* known : {".png", ".jpg", ".jpeg", ".webp"})
            EXPECT_THAT(format.error().what, testing::HasSubstr(known));
    }
    for (const PictureFormat format : {PictureFormat::Png, PictureFormat::Jpeg, PictureFormat::Webp})
        EXPECT_EQ(pictureFormatOf("x." + std::string(endingOf(format))).value(), format);
}

} // namespace
} // namespace limen::output
