#pragma once

#include "worlds/generate/House.h"
#include "worlds/generate/Land.h"
#include "worlds/generate/Random.h"
#include "worlds/records/LandblockWriter.h"

#include <limits>

namespace limen::worlds {

/// Houses that find room on a landblock.
inline constexpr std::uint32_t kMostHouses = 20;

/// Landblocks with houses, doors and fences along a street.
class TownBlocks {
public:
    /// What they are made of, and written into.
    struct Tools {
        ModelWriter& sink;
        const Props& props;
        const HouseLeaves& leaves;
        WorldNotes& notes;
        std::size_t mostDoors = std::numeric_limits<std::size_t>::max();
    };
    /// `random` is drawn from. All must outlive it.
    TownBlocks(const Tools& tools, const Land& land, Random& random)
        : tools_(tools), land_(land), random_(random) {}

    /// Adds the LandBlockInfo and all it holds of a landblock of the land, at most kMostHouses. Yields how its street lies:
    /// its own x runs along it, from the middle of the landblock.
    Placement build(int bx, int by, std::uint32_t houses);

    [[nodiscard]] std::uint32_t cells() const { return cells_; } ///< of all houses so far

private:
    void addHouse(LandblockWriter& block, dat::BlockCoord coord, const Vec3& corner, Placement at);
    /// A house that stands above the ground everywhere, its walls below it; sets the placement's height.
    [[nodiscard]] HouseSpec groundHouse(const Vec3& corner, Placement& at);
    void addFences(LandblockWriter& block, const Vec3& corner, const Placement& district);

    Tools tools_;
    const Land& land_;
    Random& random_;
    std::uint32_t house_ = 0, cells_ = 0;
};

} // namespace limen::worlds
