#include "doctor/retail/Judges.h"

#include <array>

#include <fmt/format.h>

namespace limen::doctor {
namespace {

constexpr const char* kSurfaceSource = "named record in a public test or note";

/// A value of a Surface.
enum class SurfaceField : std::uint8_t {
    Type,
    HasImage,
    Rgb,
    Argb,
    Translucency,
    Luminosity,
    Diffuse,
    Texture,
    Image
};

struct SurfaceFact {
    dat::RecordId id;
    const char* name;
    SurfaceField field;
    double expected;
};
using F = SurfaceField;
constexpr auto kSurfaceFacts = std::to_array<SurfaceFact>({
    {0x0800006B, "type", F::Type, 0x11},
    {0x0800006B, "colour", F::Rgb, 0xFFFFFF},
    {0x0800006B, "translucency", F::Translucency, 0.5},
    {0x08000005, "hasPicture", F::HasImage, 1},
    {0x08000139, "hasPicture", F::HasImage, 0},
    {0x08000139, "colour", F::Argb, 0xFFC8C8C8},
    {0x080000DD, "colour", F::Rgb, 0xC8C8C8},
    {0x080000DD, "translucency", F::Translucency, 1.0},
    {0x080000C5, "type", F::Type, 0x10112},
    {0x080000C5, "translucency", F::Translucency, 0.5},
    {0x080000C5, "luminosity", F::Luminosity, 0.148},
    {0x080000C5, "texture", F::Texture, 0x05001A26},
    {0x080000C5, "picture", F::Image, 0x06004002},
    {0x08000DCB, "type", F::Type, 0x2},
    {0x08000DCB, "texture", F::Texture, 0x05001A9A},
    {0x08000DCB, "diffuse", F::Diffuse, 0.800781},
    {0x08000219, "type", F::Type, 0x1},
    {0x08000219, "colour", F::Argb, 0xFF6F3916},
});

bool isHex(SurfaceField field) {
    return field == F::Type || field == F::Rgb || field == F::Argb || field == F::Texture ||
           field == F::Image;
}

/// Whether a SurfaceTexture lists a picture.
std::optional<Numbers> listedPicture(const dat::Archive& archive, const dat::Surface& surface,
                                     double expected) {
    const Result<dat::SurfaceTexture> texture = archive.load<dat::SurfaceTexture>(surface.texture);
    if (!texture || texture->images.empty())
        return std::nullopt;
    for (const dat::RecordId image : texture->images)
        if (image == expected)
            return Numbers{expected};
    return Numbers{static_cast<double>(texture->images.front())};
}

std::optional<Numbers> valueOf(const dat::Archive& archive, const dat::Surface& s, const SurfaceFact& fact) {
    switch (fact.field) {
    case F::Type:
        return Numbers{static_cast<double>(s.type)};
    case F::HasImage:
        return Numbers{s.hasImage() ? 1.0 : 0.0};
    case F::Rgb:
        return Numbers{static_cast<double>(s.colour.argb & 0xFFFFFFu)};
    case F::Argb:
        return Numbers{static_cast<double>(s.colour.argb)};
    case F::Translucency:
        return Numbers{s.translucency};
    case F::Luminosity:
        return Numbers{s.luminosity};
    case F::Diffuse:
        return Numbers{s.diffuse};
    case F::Texture:
        return Numbers{static_cast<double>(s.texture)};
    case F::Image:
        return listedPicture(archive, s, fact.expected);
    }
    return std::nullopt;
}

} // namespace

void judgeSurfaces(const dat::Archive& archive, Ledger& ledger) {
    constexpr double kThreeDigits = 0.0005; // figures are published with three digits or more
    for (const SurfaceFact& fact : kSurfaceFacts) {
        const bool hex = isHex(fact.field);
        ledger.judgeRecord(archive.load<dat::Surface>(fact.id),
                           {fmt::format("surface.{:08X}.{}", fact.id, fact.name),
                            kSurfaceSource,
                            {fact.expected},
                            Rule::Equal,
                            hex ? 0.0 : kThreeDigits,
                            hex ? Notation::Hex : Notation::Decimal},
                           [&](const dat::Surface& surface) { return valueOf(archive, surface, fact); });
    }
}

} // namespace limen::doctor
