#pragma once

#include "worlds/records/CellPlan.h"
#include "worlds/records/ModelWriter.h"
#include "worlds/records/ShapeLibrary.h"

#include <span>

namespace limen::worlds {

/// How the cells of a plan become records.
struct CellRules {
    enum class Tree {
        Chain, ///< in front of every plane: exact for convex cells (buildCellBsp)
        Solid  ///< exact for any closed cell (buildSolidCellBsp)
    };
    Tree tree = Tree::Chain;
    bool environmentPerPlan = true; ///< else plans share Environments
    /// kSeenOutside by sampled rays; else for cells within `listSteps` openings of an exit.
    bool samplesDaylight = true;
    std::size_t listSteps = kAnyStep; ///< openings that lists of visible cells look through
};
inline constexpr CellRules kBuiltInCells{};
inline constexpr CellRules kGeneratedCells{CellRules::Tree::Solid, false, false, 3};

/// A cell whose shape is stored, in the coordinates of its landblock.
struct PlacedCell {
    StoredShape shape;
    Placement at;
    std::vector<CellLink> links;        ///< one for each portal of the shape
    std::vector<Furnishing> statics;    ///< in the landblock's coordinates
    std::vector<std::uint32_t> visible; ///< cells of the same call, ascending
    bool seesOutside = false;
};

/// Writes one landblock's LandBlockInfo and EnvCells. The only writer of these records.
class LandblockWriter {
public:
    LandblockWriter(ModelWriter& models, dat::BlockCoord coord, const CellRules& rules);

    void addObject(const Furnishing& object);
    /// Adds the cells of a linked plan, and a building if it has exits. All of them share the frame `at`, so
    /// that points that agree in the plan agree to the bit in the world. Returns the cells' ids in the plan's
    /// order.
    std::vector<dat::RecordId> add(const BuildingPlan& plan, const Placement& at);
    /// Adds cells that refer to each other by their index in `cells`. Returns their ids in that order.
    std::vector<dat::RecordId> addCells(std::span<const PlacedCell> cells);
    /// True if the block needs no LandBlockInfo.
    [[nodiscard]] bool empty() const {
        return info_.objects.empty() && info_.buildings.empty() && info_.numCells == 0;
    }
    /// Adds the LandBlockInfo to the records.
    void finish();

private:
    [[nodiscard]] std::uint16_t firstFreeCell() const {
        return static_cast<std::uint16_t>(dat::kFirstCell + info_.numCells);
    }
    [[nodiscard]] std::vector<bool> cellsWithDaylight(const std::vector<CellPlan>& cells,
                                                      const Neighbours& neighbours) const;
    StoredShape store(const CellPlan& cell);
    void addBuilding(const BuildingPlan& plan, const Neighbours& neighbours, std::uint16_t firstCell,
                     const Placement& at);

    ModelWriter& models_;
    CellRules rules_;
    ShapeLibrary shapes_;
    dat::LandBlockInfo info_;
};

} // namespace limen::worlds
