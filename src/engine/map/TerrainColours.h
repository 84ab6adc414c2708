#pragma once

#include "dat/Archive.h"
#include "dat/records/Landscape.h"
#include "geometry/Vec.h"

#include <array>

namespace limen::engine {

inline constexpr std::size_t kTerrainTypes = 33; ///< 0..31, and the road
inline constexpr std::size_t kRoadColour = 32;

/// Colours of terrain types seen from far above, in linear light: the mean of each type's texture, as TexMerge
/// names it. A type without a readable texture has the colour of its TerrainType record.
struct TerrainColours {
    std::array<Vec3f, kTerrainTypes> linear{};
};
[[nodiscard]] TerrainColours terrainColours(const dat::Archive& archive, const dat::Region& region);

/// Water is types 0x10..0x14 (docs/formats/landscape.md#terrain-types).
[[nodiscard]] constexpr bool isWater(std::uint32_t type) {
    return type >= 0x10 && type <= 0x14;
}

} // namespace limen::engine
