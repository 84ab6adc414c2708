#pragma once

#include "world/Stitch.h"

#include <string>

namespace limen::world {

/// Checks that a cell's one-sided polygons and portals, wound to be seen from inside, close: each edge runs
/// as often one way as the other. Two-sided polygons stand in a room without bounding it and don't count. An
/// edge that lies in the middle of a wall closes too: a pillar on a floor that runs on under it.
class CellClosure {
public:
    /// `vertices` must outlive the object.
    explicit CellClosure(std::span<const Vec3> vertices) : vertices_(vertices) {}

    void addDrawn(const StitchLoop& loop, bool front, bool back);
    /// How well a portal's winding fits the edges that the shell leaves open: > 0 as it is, < 0 reversed, 0
    /// unknown.
    [[nodiscard]] int fit(const StitchLoop& portal) const;
    void addPortal(const StitchLoop& portal, bool reversed) { addEdges(portal, reversed ? -1 : 1); }

    [[nodiscard]] bool isClosed() const { return openEdges(1) == 0; }
    /// How many edges are open, and where the first lies.
    [[nodiscard]] std::string describe() const;

private:
    void addEdges(const StitchLoop& loop, int direction);
    [[nodiscard]] bool isOnAWall(std::uint32_t a, std::uint32_t b) const;
    /// Counts open edges, stopping at `limit`; `first` gets the first one's key.
    std::size_t openEdges(std::size_t limit, std::uint64_t* first = nullptr) const;

    std::span<const Vec3> vertices_;
    std::unordered_map<std::uint64_t, int>
        balance_; ///< by edge: times from the smaller vertex minus times to it
    std::vector<std::vector<Vec3>> walls_;
};

} // namespace limen::world
