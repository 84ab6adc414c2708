#include "engine/map/TerrainColours.h"

#include "engine/picture/LinearFilter.h"
#include "world/Single.h"

#include <algorithm>
#include <map>

namespace limen::engine {
namespace {

/// The mean of a picture's texels, in linear light.
Vec3f meanOf(const world::Image& image, const LinearMean& light) {
    Vec3 sum(0.0);
    const std::size_t texels = image.rgba.size() / 4;
    for (std::size_t i = 0; i < texels; ++i)
        for (int channel = 0; channel < 3; ++channel)
            sum[channel] +=
                static_cast<double>(light.linear(image.rgba[i * 4 + static_cast<std::size_t>(channel)]));
    return texels > 0 ? Vec3f(sum / static_cast<double>(texels)) : Vec3f(0.0f);
}

Vec3f linearOf(dat::Colour colour, const LinearMean& light) {
    const auto channel = [&](int shift) {
        return light.linear(static_cast<std::uint8_t>(colour.argb >> shift & 0xFFu));
    };
    return {channel(16), channel(8), channel(0)};
}

} // namespace

TerrainColours terrainColours(const dat::Archive& archive, const dat::Region& region) {
    const LinearMean light;
    TerrainColours colours;
    for (std::size_t i = 0; i < kTerrainTypes; ++i)
        colours.linear[i] = i < region.terrainTypes.size() ? linearOf(region.terrainTypes[i].colour, light)
                            : i == kRoadColour             ? Vec3f(0.25f, 0.2f, 0.15f)
                                                           : Vec3f(0.05f, 0.08f, 0.04f);
    std::map<dat::RecordId, std::optional<Vec3f>> means;
    for (const dat::TerrainTexture& texture : region.texMerge.textures) {
        if (texture.terrainType >= kTerrainTypes)
            continue;
        const auto [entry, fresh] = means.try_emplace(texture.texture);
        if (fresh)
            if (const Result<world::Image> image = world::loadPicture(archive, texture.texture))
                entry->second = meanOf(*image, light);
        if (entry->second)
            colours.linear[texture.terrainType] = *entry->second;
    }
    return colours;
}

} // namespace limen::engine
