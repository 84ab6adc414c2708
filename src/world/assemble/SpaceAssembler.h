#pragma once

#include "world/assemble/JoiningBlock.h"

namespace limen::world {

/// Adds blocks with their cells, zones and portals to a World. Starts with the outside as space 0 and zone 0.
class SpaceAssembler {
public:
    explicit SpaceAssembler(World& world);

    /// Requires: blocks come in ascending order of (x, y). `content` must outlive the result.
    [[nodiscard]] JoiningBlock add(const BlockContent& content);
    /// Moves the outside's portals to the front of World::portals. Until then, indices of portals are not
    /// final. Called once.
    void finish();

private:
    void addBlock(const BlockContent& content);
    void addCells(const JoiningBlock& block);
    void addZones(const JoiningBlock& block);
    void addPortals(const JoiningBlock& block);
    [[nodiscard]] Portal portalOf(const JoiningBlock& block, const PortalContent& content);

    World& world_;
    std::vector<Portal> outdoorPortals_; ///< until finish()
};

} // namespace limen::world
