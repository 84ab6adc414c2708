#pragma once

#include "dat/Archive.h"
#include "engine/places/Obstacles.h"
#include "world/records/Pose.h"
#include "world/records/Records.h"

#include <array>
#include <map>
#include <memory>
#include <optional>

// Shapes of single cells, buildings and blocks, read without loading a part of the world: no textures and no
// neighbours. All positions are global metres.
namespace limen::engine {

/// An opening of a cell.
struct Opening {
    std::vector<Vec3> outline;
    Vec3 middle{0.0};
    Vec3 inward{0.0};            ///< unit normal into the cell
    double sill = 0.0;           ///< lowest corner
    double height = 0.0;         ///< metres
    double width = 0.0;          ///< largest horizontal extent, metres
    dat::RecordId otherCell = 0; ///< 0: the outside
    std::uint16_t otherPortal = 0;

    /// True if an upright body fits through: a door, and no window or shaft.
    [[nodiscard]] bool isDoor() const;
    /// The eye of a body that stands on the sill, in the opening's plane.
    [[nodiscard]] Vec3 eye() const;
};

struct CellShape {
    dat::RecordId id = 0;
    std::vector<std::vector<Vec3>>
        walls; ///< drawn polygons without those of portals, counter-clockwise seen from inside
    std::vector<Opening> openings; ///< by portal of the record
    Obstacles solids;              ///< its walls and its static objects
};

struct BuildingShape {
    dat::Building record;
    Vec3 middle{0.0}; ///< of its exterior's bounds
    Aabb bounds;
};

/// One landblock outdoors.
struct BlockShape {
    dat::BlockCoord coord;
    std::vector<BuildingShape> buildings;
    Obstacles solids; ///< exteriors, objects and scenery
};

/// Reads shapes. Missing or damaged records are left out. Not thread-safe.
class Shapes {
public:
    explicit Shapes(const dat::Archive& archive);

    /// Null if the cell or its shape is missing. Valid until forget().
    [[nodiscard]] const CellShape* cell(dat::RecordId id);
    /// Valid until forget().
    [[nodiscard]] const BlockShape& block(dat::BlockCoord coord);
    /// Height of the ground; NaN without a LandBlock record or Region.
    [[nodiscard]] double ground(double x, double y);
    /// Drops cells and blocks, and keeps the records of models.
    void forget();

private:
    using Heights = std::array<float, 81>;
    [[nodiscard]] const std::optional<Heights>& heights(dat::BlockCoord coord);
    void addModel(dat::RecordId model, const world::Pose& pose, double scale, std::vector<Triangle>& out);
    void addGfxObj(dat::RecordId id, const Mat3& linear, const Vec3& origin, std::vector<Triangle>& out);
    void addScenery(BlockShape& block);
    [[nodiscard]] std::optional<CellShape> readCell(dat::RecordId id);
    [[nodiscard]] BlockShape readBlock(dat::BlockCoord coord);

    const dat::Archive& archive_;
    world::Records records_;
    std::unique_ptr<dat::Region> region_;
    std::map<dat::RecordId, std::optional<CellShape>> cells_;
    std::map<dat::RecordId, BlockShape> blocks_;
    std::map<dat::RecordId, std::optional<Heights>> heights_;
};

/// The south-west corner of a block.
[[nodiscard]] Vec3 originOf(dat::BlockCoord block);

} // namespace limen::engine
