#pragma once

#include "worlds/Building.h"
#include "worlds/generate/ShapeLibrary.h"

namespace limen::worlds {

/// Where an opening of a planned cell leads: a cell of the same plan and its opening that leads back, or outside.
struct PlannedPortal {
    std::uint32_t cell = kOutside;
    std::uint16_t portal = dat::kNoPortal;
    bool exact = true;          ///< both cells' polygons are one
    bool insidePositive = true; ///< how the record's polygon is wound, and its flag with it
    static constexpr std::uint32_t kOutside = 0xFFFFFFFFu;
};

/// A cell in the coordinates of its plan: a closed shell that looks inwards, portal faces in the order of `portals`.
struct PlannedCell {
    std::vector<Face> faces;
    std::vector<PlannedPortal> portals;
    std::vector<Furnishing> statics;
    Vec3 eye{0.0}; ///< a point inside to stand at
};

/// Cells in a frame of their own, and a building around them if any of them leads outside.
struct CellsPlan {
    std::vector<PlannedCell> cells;
    MeshBuilder exterior; ///< its portal faces, outward, are `exits`
    struct Exit {
        std::uint32_t cell = 0;
        std::uint16_t portal = 0;
    };
    std::vector<Exit> exits;
};

/// One landblock being filled with plans whose openings are linked by index.
class PlanWriter {
public:
    PlanWriter(ModelSink& sink, ShapeLibrary& shapes, dat::BlockCoord coord);

    void addObject(const Furnishing& object) { info_.objects.push_back({object.model, toFrame(object.at)}); }
    /// Yields the first cell's id; the others follow.
    dat::RecordId add(CellsPlan plan, const Placement& at);
    /// Adds the LandBlockInfo to the records.
    void finish() { sink_.records().landBlockInfos.push_back(std::move(info_)); }

private:
    ModelSink& sink_;
    ShapeLibrary& shapes_;
    dat::LandBlockInfo info_;
};

/// Cells within so many openings of each, itself included, ascending: for lists of visible cells.
[[nodiscard]] std::vector<std::uint32_t>
cellsWithin(const std::vector<std::vector<std::uint32_t>>& neighbours, std::uint32_t cell, std::size_t steps);

/// Global metres from a landblock's own.
[[nodiscard]] inline Vec3 blockToGlobal(dat::BlockCoord coord, const Vec3& local) {
    return local + Vec3(coord.x * 192.0, coord.y * 192.0, 0.0);
}

} // namespace limen::worlds
