#pragma once

#include "output/Picture.h"

#include <filesystem>

// Pictures as bytes of a picture file. All functions are pure.
namespace limen::output {

enum class PictureFormat : std::uint8_t { Png, Jpeg, Webp };

/// Of a lossy format, 1..100; 100 is the best.
inline constexpr int kPictureQuality = 90;

/// The format that a file name's ending selects, in any case: .png, .jpg, .jpeg, .webp. Names below /dev/
/// select PNG. Errors: BadArgument for another ending; the message lists the known ones.
[[nodiscard]] Result<PictureFormat> pictureFormatOf(const std::filesystem::path& path);
/// The ending of a format, without the dot: "png", "jpg", "webp".
[[nodiscard]] std::string_view endingOf(PictureFormat format);
/// The media type of a format, such as "image/png".
[[nodiscard]] std::string_view mediaTypeOf(PictureFormat format);

/// Encodes a picture as PNG, RGB with 8 bits a channel. Errors: no pixels; out of memory.
[[nodiscard]] Result<std::vector<std::byte>> encodePng(const Picture& picture);
/// Encodes R, G, B, A bytes as PNG with alpha, not premultiplied. Requires rgba.size() == width*height*4.
/// Errors: no pixels; out of memory.
[[nodiscard]] Result<std::vector<std::byte>> encodePng(std::uint32_t width, std::uint32_t height,
                                                       std::span<const std::uint8_t> rgba);
/// Encodes a picture as JPEG with full colour resolution. Errors: no pixels; a side above 65,500 pixels.
[[nodiscard]] Result<std::vector<std::byte>> encodeJpeg(const Picture& picture,
                                                        int quality = kPictureQuality);
/// Encodes a picture as lossy WebP. Errors: no pixels; a side above 16,383 pixels; out of memory.
[[nodiscard]] Result<std::vector<std::byte>> encodeWebp(const Picture& picture,
                                                        int quality = kPictureQuality);
/// Encodes a picture in a format. Errors: those of the format.
[[nodiscard]] Result<std::vector<std::byte>> encodePicture(const Picture& picture, PictureFormat format);

} // namespace limen::output
