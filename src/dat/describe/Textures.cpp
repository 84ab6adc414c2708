#include "dat/Describe.h"
#include "dat/describe/Json.h"

#include <fmt/format.h>

namespace limen::dat {
namespace {

Json formatName(PixelFormat format) {
    switch (format) {
    case PixelFormat::R8G8B8:
        return "R8G8B8";
    case PixelFormat::A8R8G8B8:
        return "A8R8G8B8";
    case PixelFormat::X8R8G8B8:
        return "X8R8G8B8";
    case PixelFormat::R5G6B5:
        return "R5G6B5";
    case PixelFormat::X1R5G5B5:
        return "X1R5G5B5";
    case PixelFormat::A1R5G5B5:
        return "A1R5G5B5";
    case PixelFormat::A4R4G4B4:
        return "A4R4G4B4";
    case PixelFormat::A8:
        return "A8";
    case PixelFormat::P8:
        return "P8";
    case PixelFormat::L8:
        return "L8";
    case PixelFormat::Index16:
        return "INDEX16";
    case PixelFormat::LandscapeR8G8B8:
        return "CUSTOM_LSCAPE_R8G8B8";
    case PixelFormat::LandscapeAlpha:
        return "CUSTOM_LSCAPE_ALPHA";
    case PixelFormat::RawJpeg:
        return "CUSTOM_RAW_JPEG";
    case PixelFormat::Dxt1:
        return "DXT1";
    case PixelFormat::Dxt3:
        return "DXT3";
    case PixelFormat::Dxt5:
        return "DXT5";
    }
    return hexId(static_cast<std::uint32_t>(format));
}

struct FlagName {
    std::uint32_t bit;
    const char* name;
};
constexpr FlagName kSurfaceFlags[] = {{Surface::kBase1Solid, "Base1Solid"},
                                      {Surface::kBase1Image, "Base1Image"},
                                      {Surface::kBase1ClipMap, "Base1ClipMap"},
                                      {Surface::kTranslucent, "Translucent"},
                                      {Surface::kDiffuse, "Diffuse"},
                                      {Surface::kLuminous, "Luminous"},
                                      {Surface::kAlpha, "Alpha"},
                                      {Surface::kInvAlpha, "InvAlpha"},
                                      {Surface::kAdditive, "Additive"},
                                      {Surface::kDetail, "Detail"},
                                      {Surface::kGouraud, "Gouraud"},
                                      {Surface::kStippled, "Stippled"},
                                      {Surface::kPerspective, "Perspective"}};

} // namespace

std::string describe(const Palette& p) {
    return pretty({{"kind", "Palette"},
                   {"id", hexId(p.id)},
                   {"colours", listOf(p.colours, [](const Colour& c) { return json(c); })}});
}

std::string describe(const SurfaceTexture& s) {
    return pretty({{"kind", "SurfaceTexture"},
                   {"id", hexId(s.id)},
                   {"category", s.category},
                   {"type", s.type},
                   {"images", hexIds(s.images)}});
}

std::string describe(const RenderSurface& s) {
    Json out = {{"kind", "RenderSurface"}, {"id", hexId(s.id)},  {"category", s.category},
                {"width", s.width},        {"height", s.height}, {"format", formatName(s.format)},
                {"bytes", s.pixels.size()}};
    if (s.format == PixelFormat::P8 || s.format == PixelFormat::Index16)
        out["default_palette"] = hexId(s.defaultPalette);
    return pretty(out);
}

std::string describe(const Surface& s) {
    Json flags = Json::array();
    for (const FlagName& flag : kSurfaceFlags)
        if (s.type & flag.bit)
            flags.push_back(flag.name);
    Json out = {{"kind", "Surface"}, {"type", hexId(s.type)}, {"flags", flags}};
    if (s.hasImage()) {
        out["texture"] = hexId(s.texture);
        out["palette"] = hexId(s.palette);
    } else {
        out["colour"] = json(s.colour);
    }
    out["translucency"] = number(s.translucency);
    out["luminosity"] = number(s.luminosity);
    out["diffuse"] = number(s.diffuse);
    return pretty(out);
}

} // namespace limen::dat
