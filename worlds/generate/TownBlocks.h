#pragma once

#include "worlds/generate/House.h"
#include "worlds/generate/Land.h"
#include "worlds/records/LandblockWriter.h"
#include "worlds/shapes/Random.h"

#include <limits>

namespace limen::worlds {

/// The number of houses that fit on a landblock.
inline constexpr std::uint32_t kMostHouses = 20;

/// Builds landblocks with houses, doors and fences along a street.
class TownBlocks {
public:
    /// The models to use, and the writer and the notes to write to.
    struct Tools {
        ModelWriter& writer;
        const Props& props;
        const HouseLeaves& leaves;
        WorldNotes& notes;
        std::size_t mostDoors = std::numeric_limits<std::size_t>::max();
    };
    /// All arguments must outlive this object.
    TownBlocks(const Tools& tools, const Land& land, Random& random)
        : tools_(tools), land_(land), random_(random) {}

    /// Adds the LandBlockInfo and the cells of a landblock with at most kMostHouses houses. Returns the
    /// placement of its street: x is along the street, the origin is the middle of the landblock.
    Placement build(int bx, int by, std::uint32_t houses);

    [[nodiscard]] std::uint32_t cells() const { return cells_; } ///< of all houses so far

private:
    void addHouse(LandblockWriter& block, dat::BlockCoord coord, const Vec3& corner, Placement at);
    /// A house whose floor is above the ground everywhere and whose walls end below it. Sets the placement's
    /// height.
    [[nodiscard]] HouseSpec groundHouse(const Vec3& corner, Placement& at);
    void addFences(LandblockWriter& block, const Vec3& corner, const Placement& district);

    Tools tools_;
    const Land& land_;
    Random& random_;
    std::uint32_t house_ = 0, cells_ = 0;
};

} // namespace limen::worlds
