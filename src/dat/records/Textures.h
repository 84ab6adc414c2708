#pragma once

#include "dat/records/Primitives.h"

// Surface (0x08), SurfaceTexture (0x05), RenderSurface (0x06), Palette (0x04): docs/formats/textures.md.
LIMEN_API_BEGIN
namespace limen::dat {

struct Palette {
    std::uint32_t id = 0;
    std::vector<Colour> colours;
};

struct SurfaceTexture {
    std::uint32_t id = 0;
    std::uint32_t category = 0;
    std::uint8_t type = 2;             ///< 2 = two-dimensional
    std::vector<std::uint32_t> images; ///< RenderSurface ids, largest first
};

enum class PixelFormat : std::uint32_t {
    R8G8B8 = 0x14,
    A8R8G8B8 = 0x15,
    X8R8G8B8 = 0x16,
    R5G6B5 = 0x17,
    X1R5G5B5 = 0x18,
    A1R5G5B5 = 0x19,
    A4R4G4B4 = 0x1A,
    A8 = 0x1C,
    P8 = 0x29,
    L8 = 0x32,
    Index16 = 0x65,
    LandscapeR8G8B8 = 0xF3,
    LandscapeAlpha = 0xF4,
    RawJpeg = 0x1F4,
    Dxt1 = 0x31545844,
    Dxt3 = 0x33545844,
    Dxt5 = 0x35545844
};

struct RenderSurface {
    std::uint32_t id = 0;
    std::uint32_t category = 0;
    std::int32_t width = 0;
    std::int32_t height = 0;
    PixelFormat format = PixelFormat::A8R8G8B8;
    std::vector<std::uint8_t> pixels; ///< top row first, no padding, no mip maps
    std::uint32_t defaultPalette = 0; ///< stored only for P8 and Index16
};

struct Surface {
    static constexpr std::uint32_t kBase1Solid = 1, kBase1Image = 2, kBase1ClipMap = 4, kTranslucent = 0x10,
                                   kDiffuse = 0x20, kLuminous = 0x40, kAlpha = 0x100, kInvAlpha = 0x200,
                                   kAdditive = 0x10000, kDetail = 0x20000, kGouraud = 0x10000000,
                                   kStippled = 0x40000000, kPerspective = 0x80000000;
    std::uint32_t type = 0;
    std::uint32_t texture = 0; ///< SurfaceTexture id; stored iff type & (kBase1Image | kBase1ClipMap)
    std::uint32_t palette = 0; ///< stored iff type & (kBase1Image | kBase1ClipMap)
    Colour colour;             ///< stored otherwise
    float translucency = 0.0f; ///< 0 opaque .. 1 invisible
    float luminosity = 0.0f;
    float diffuse = 1.0f;

    [[nodiscard]] bool hasImage() const { return (type & (kBase1Image | kBase1ClipMap)) != 0; }
};

} // namespace limen::dat
LIMEN_API_END
