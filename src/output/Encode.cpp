#include "output/Encode.h"

#include "core/Assert.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <memory>
#include <png.h>
#include <turbojpeg.h>
#include <webp/encode.h>

namespace limen::output {
namespace {

constexpr std::uint32_t kMostJpegSide = 65'500; ///< pixels; libjpeg's JPEG_MAX_DIMENSION

/// Errors: a picture without pixels, or with a side above `mostSide`.
Result<void> checkSides(const char* format, std::uint32_t width, std::uint32_t height,
                        std::uint32_t mostSide) {
    if (width == 0 || height == 0)
        return fail(ErrorCode::BadArgument, format, "a picture without pixels cannot be encoded");
    if (std::max(width, height) > mostSide)
        return fail(ErrorCode::Unsupported, format,
                    fmt::format("a picture of {}x{} pixels does not fit; the largest side is {}; choose a "
                                "smaller --size or write a .png file",
                                width, height, mostSide));
    return {};
}

Result<std::vector<std::byte>> encodePngAs(png_uint_32 format, std::uint32_t width, std::uint32_t height,
                                           std::span<const std::uint8_t> pixels) {
    if (Result<void> fits = checkSides("PNG", width, height, PNG_UINT_31_MAX); !fits)
        return Failure(fits.error());
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = width;
    image.height = height;
    image.format = format;
    image.flags = PNG_IMAGE_FLAG_FAST;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::vector<std::byte> bytes(size);
    if (png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr) == 0)
        return fail(ErrorCode::Unsupported, "PNG",
                    fmt::format("the picture cannot be encoded: {}", image.message));
    bytes.resize(size);
    return bytes;
}

std::vector<std::byte> bytesOf(const std::uint8_t* data, std::size_t size) {
    const std::span<const std::byte> bytes = std::as_bytes(std::span(data, size));
    return {bytes.begin(), bytes.end()};
}

} // namespace

Result<PictureFormat> pictureFormatOf(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending == ".png" || path.string().starts_with("/dev/"))
        return PictureFormat::Png;
    if (ending == ".jpg" || ending == ".jpeg")
        return PictureFormat::Jpeg;
    if (ending == ".webp")
        return PictureFormat::Webp;
    return fail(ErrorCode::BadArgument, path.string(),
                ending.empty() ? "has no ending that names a picture format; use .png, .jpg, .jpeg or .webp"
                               : fmt::format("the ending {} names no known picture format; use .png, .jpg, "
                                             ".jpeg or .webp",
                                             ending));
}

std::string_view endingOf(PictureFormat format) {
    constexpr std::array<std::string_view, 3> kEndings{"png", "jpg", "webp"};
    return kEndings[static_cast<std::size_t>(format)];
}

std::string_view mediaTypeOf(PictureFormat format) {
    constexpr std::array<std::string_view, 3> kTypes{"image/png", "image/jpeg", "image/webp"};
    return kTypes[static_cast<std::size_t>(format)];
}

Result<std::vector<std::byte>> encodePng(const Picture& picture) {
    return encodePngAs(PNG_FORMAT_RGB, picture.width, picture.height, picture.rgb);
}

Result<std::vector<std::byte>> encodePng(std::uint32_t width, std::uint32_t height,
                                         std::span<const std::uint8_t> rgba) {
    LIMEN_ASSERT(rgba.size() == static_cast<std::size_t>(width) * height * 4, "four bytes a pixel");
    return encodePngAs(PNG_FORMAT_RGBA, width, height, rgba);
}

Result<std::vector<std::byte>> encodeJpeg(const Picture& picture, int quality) {
    LIMEN_ASSERT(quality >= 1 && quality <= 100, "a quality of JPEG");
    if (Result<void> fits = checkSides("JPEG", picture.width, picture.height, kMostJpegSide); !fits)
        return Failure(fits.error());
    const std::unique_ptr<void, int (*)(tjhandle)> encoder(tjInitCompress(), &tjDestroy);
    unsigned char* data = nullptr;
    unsigned long size = 0;
    const bool isDone =
        encoder && tjCompress2(encoder.get(), picture.rgb.data(), static_cast<int>(picture.width), 0,
                               static_cast<int>(picture.height), TJPF_RGB, &data, &size, TJSAMP_444, quality,
                               TJFLAG_ACCURATEDCT) == 0;
    const std::unique_ptr<unsigned char, void (*)(unsigned char*)> owned(data, &tjFree);
    if (!isDone)
        return fail(ErrorCode::Unsupported, "JPEG",
                    fmt::format("the picture cannot be encoded: {}", tjGetErrorStr2(encoder.get())));
    return bytesOf(data, size);
}

Result<std::vector<std::byte>> encodeWebp(const Picture& picture, int quality) {
    LIMEN_ASSERT(quality >= 1 && quality <= 100, "a quality of WebP");
    if (Result<void> fits = checkSides("WebP", picture.width, picture.height, WEBP_MAX_DIMENSION); !fits)
        return Failure(fits.error());
    std::uint8_t* data = nullptr;
    const std::size_t size =
        WebPEncodeRGB(picture.rgb.data(), static_cast<int>(picture.width), static_cast<int>(picture.height),
                      static_cast<int>(picture.width) * 3, static_cast<float>(quality), &data);
    const std::unique_ptr<std::uint8_t, void (*)(void*)> owned(data, &WebPFree);
    if (size == 0)
        return fail(ErrorCode::Unsupported, "WebP",
                    "the picture cannot be encoded; write a .png file instead");
    return bytesOf(data, size);
}

Result<std::vector<std::byte>> encodePicture(const Picture& picture, PictureFormat format) {
    switch (format) {
    case PictureFormat::Png:
        return encodePng(picture);
    case PictureFormat::Jpeg:
        return encodeJpeg(picture);
    case PictureFormat::Webp:
        return encodeWebp(picture);
    }
    return encodePng(picture);
}

} // namespace limen::output
