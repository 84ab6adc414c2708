#include "dat/codec/Layout.h"

#include <optional>

namespace limen::dat {
namespace {

constexpr std::int32_t kMaxDimension = 4096;

/// Bytes of an image; no value for an unknown format; 0 for raw JPEG, whose size varies.
std::optional<std::size_t> pixelBytes(PixelFormat format, std::size_t width, std::size_t height) {
    const std::size_t texels = width * height;
    const std::size_t blocks = ((width + 3) / 4) * ((height + 3) / 4);
    switch (format) {
    case PixelFormat::A8R8G8B8:
    case PixelFormat::X8R8G8B8:
        return texels * 4;
    case PixelFormat::R8G8B8:
    case PixelFormat::LandscapeR8G8B8:
        return texels * 3;
    case PixelFormat::R5G6B5:
    case PixelFormat::X1R5G5B5:
    case PixelFormat::A1R5G5B5:
    case PixelFormat::A4R4G4B4:
    case PixelFormat::Index16:
        return texels * 2;
    case PixelFormat::A8:
    case PixelFormat::P8:
    case PixelFormat::L8:
    case PixelFormat::LandscapeAlpha:
        return texels;
    case PixelFormat::Dxt1:
        return blocks * 8;
    case PixelFormat::Dxt3:
    case PixelFormat::Dxt5:
        return blocks * 16;
    case PixelFormat::RawJpeg:
        return 0;
    }
    return std::nullopt;
}

/// Refuses sizes that are absurd or do not match the number of bytes. A raw JPEG contains its size.
void checkImage(ByteReader& io, const RenderSurface& s, std::size_t formatOffset, std::size_t byteCount) {
    if (io.failed())
        return;
    const auto inRange = [](std::int32_t n) { return n >= 0 && n <= kMaxDimension; };
    const bool isJpeg = s.format == PixelFormat::RawJpeg;
    if (!isJpeg && (!inRange(s.width) || !inRange(s.height))) {
        io.failAt(formatOffset - 8, fmt::format("the image has {} x {} texels; each side may have 0 to {}",
                                                s.width, s.height, kMaxDimension));
        return;
    }
    const auto expected =
        isJpeg ? std::optional<std::size_t>(byteCount)
               : pixelBytes(s.format, static_cast<std::size_t>(s.width), static_cast<std::size_t>(s.height));
    if (!expected) {
        io.failAt(formatOffset,
                  fmt::format("pixel format 0x{:X} is not supported", static_cast<std::uint32_t>(s.format)),
                  ErrorCode::Unsupported);
    } else if (*expected != byteCount) {
        io.failAt(formatOffset + 4,
                  fmt::format("the image has {} bytes; {}x{} texels of format 0x{:X} take {}", byteCount,
                              s.width, s.height, static_cast<std::uint32_t>(s.format), *expected));
    }
}
[[maybe_unused]] void checkImage(ByteWriter&, const RenderSurface&, std::size_t, std::size_t) {}

std::size_t pixelCount(ByteReader& io, const RenderSurface&) {
    return io.count<std::int32_t>("image bytes");
}
std::size_t pixelCount(ByteWriter& io, const RenderSurface& s) {
    io.count<std::int32_t>(s.pixels.size());
    return s.pixels.size();
}

bool storesPalette(PixelFormat format) {
    return format == PixelFormat::P8 || format == PixelFormat::Index16;
}

template <class IO, class S>
void renderSurface(IO& io, RecordId key, S& s) {
    ownId(io, key, s.id);
    io.value(s.category);
    io.value(s.width);
    io.value(s.height);
    const std::size_t formatOffset = io.offset();
    io.value(s.format);
    const std::size_t byteCount = pixelCount(io, s);
    checkImage(io, s, formatOffset, byteCount);
    io.array(s.pixels, byteCount);
    if (storesPalette(s.format))
        io.value(s.defaultPalette);
}

template <class IO, class S>
void surfaceTexture(IO& io, RecordId key, S& s) {
    ownId(io, key, s.id);
    io.value(s.category);
    io.value(s.type);
    values<std::int32_t>(io, s.images, "images");
}

template <class IO, class P>
void palette(IO& io, RecordId key, P& p) {
    ownId(io, key, p.id);
    io.template list<std::int32_t>(p.colours, 4, "colours", [&](auto& c) { colour(io, c); });
}

template <class IO, class S>
void surface(IO& io, S& s) {
    io.value(s.type);
    if (s.hasImage()) {
        io.value(s.texture);
        io.value(s.palette);
    } else {
        colour(io, s.colour);
    }
    io.value(s.translucency);
    io.value(s.luminosity);
    io.value(s.diffuse);
}

} // namespace

template <>
Result<RenderSurface> decode<RenderSurface>(RecordId id, ByteView payload) {
    return decodeWith<RenderSurface>(id, payload,
                                     [&](ByteReader& io, RenderSurface& s) { renderSurface(io, id, s); });
}
template <>
Result<Bytes> encode<RenderSurface>(const RenderSurface& s) {
    ByteWriter io;
    renderSurface(io, s.id, s);
    return io.take(s.id);
}

template <>
Result<SurfaceTexture> decode<SurfaceTexture>(RecordId id, ByteView payload) {
    return decodeWith<SurfaceTexture>(id, payload,
                                      [&](ByteReader& io, SurfaceTexture& s) { surfaceTexture(io, id, s); });
}
template <>
Result<Bytes> encode<SurfaceTexture>(const SurfaceTexture& s) {
    ByteWriter io;
    surfaceTexture(io, s.id, s);
    return io.take(s.id);
}

template <>
Result<Palette> decode<Palette>(RecordId id, ByteView payload) {
    return decodeWith<Palette>(id, payload, [&](ByteReader& io, Palette& p) { palette(io, id, p); });
}
template <>
Result<Bytes> encode<Palette>(const Palette& p) {
    ByteWriter io;
    palette(io, p.id, p);
    return io.take(p.id);
}

template <>
Result<Surface> decode<Surface>(RecordId id, ByteView payload) {
    return decodeWith<Surface>(id, payload, [&](ByteReader& io, Surface& s) { surface(io, s); });
}
template <>
Result<Bytes> encode<Surface>(const Surface& s) {
    ByteWriter io;
    surface(io, s);
    return io.takeNamed("Surface");
}

} // namespace limen::dat
