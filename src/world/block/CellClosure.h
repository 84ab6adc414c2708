#pragma once

#include "world/mesh/Stitch.h"

#include <string>

namespace limen::world {

/// Checks that a cell is closed: that each edge of its one-sided polygons and portals, wound as seen from
/// inside, runs as often one way as the other. Two-sided polygons are inside a room without bounding it and
/// do not count. An edge in the middle of a wall counts as closed, as of a pillar on a floor that continues
/// beneath it.
class CellClosure {
public:
    /// `vertices` must outlive the object.
    explicit CellClosure(std::span<const Vec3> vertices) : vertices_(vertices) {}

    void addDrawn(const StitchLoop& loop, bool front, bool back);
    /// Compares a portal's winding with the edges that the shell leaves open: > 0 it fits, < 0 its reverse
    /// fits, 0 unknown.
    [[nodiscard]] int fit(const StitchLoop& portal) const;
    void addPortal(const StitchLoop& portal, bool reversed) { addEdges(portal, reversed ? -1 : 1); }

    [[nodiscard]] bool isClosed() const { return openEdges(1) == 0; }
    /// For a finding: the number of open edges, and the ends of the first.
    [[nodiscard]] std::string describe() const;

private:
    void addEdges(const StitchLoop& loop, int direction);
    [[nodiscard]] bool isOnAWall(std::uint32_t a, std::uint32_t b) const;
    /// The number of open edges, at most `limit`. `first` gets the smallest key of those counted.
    std::size_t openEdges(std::size_t limit, std::uint64_t* first = nullptr) const;

    std::span<const Vec3> vertices_;
    /// By edge: the number of polygons that run along it from the smaller vertex, minus those that run to it.
    std::unordered_map<std::uint64_t, int> balance_;
    std::vector<std::vector<Vec3>> walls_;
};

} // namespace limen::world
