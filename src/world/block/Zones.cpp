#include "world/block/Zones.h"

#include "core/Assert.h"

#include <algorithm>
#include <optional>

namespace limen::world {
namespace {

/// Cells with more points are compared by their boxes alone, because testing all axes would take too long.
constexpr std::size_t kMaxPoints = 20000;

struct Interval {
    double low = 1e300, high = -1e300;
};

Interval project(const std::vector<Vec3>& points, const Vec3& axis) {
    Interval out;
    for (const Vec3& p : points) {
        const double t = glm::dot(p, axis);
        out.low = std::min(out.low, t);
        out.high = std::max(out.high, t);
    }
    return out;
}

bool parts(const CellShape& a, const CellShape& b, const Vec3& axis) {
    const Interval i = project(a.points, axis), j = project(b.points, axis);
    return i.high - j.low <= kOverlapTolerance || j.high - i.low <= kOverlapTolerance;
}

bool boxesPart(const Aabb& a, const Aabb& b) {
    for (int axis = 0; axis < 3; ++axis)
        if (a.max[axis] - b.min[axis] <= kOverlapTolerance || b.max[axis] - a.min[axis] <= kOverlapTolerance)
            return true;
    return false;
}

bool isNear(const PortalContent& portal, const Aabb& bounds) {
    Aabb box;
    for (const Vec3& p : portal.points)
        box.include(p);
    return glm::all(glm::lessThanEqual(box.min - kInPlaneTolerance, bounds.max)) &&
           glm::all(glm::greaterThanEqual(box.max + kInPlaneTolerance, bounds.min));
}

/// True if walls of a cell that are in a portal's plane overlap the portal by more than `least`, in metres; negative: are
/// nearer to it than that. May be true for walls that wind around it.
bool hasWallIn(const PortalContent& portal, const CellShape& shape, double least) {
    std::vector<Vec3> wall;
    for (const Vec3& p : shape.points)
        if (std::abs(portal.plane.signedDistance(p)) <= kInPlaneTolerance)
            wall.push_back(p);
    const auto partedAlong = [&](const Vec3& direction) {
        const Vec3 across = glm::cross(direction, portal.plane.n);
        const double length = glm::length(across);
        if (length < 0.5)
            return false; // not in the plane
        const Interval i = project(wall, across / length), j = project(portal.points, across / length);
        return i.high - j.low <= least || j.high - i.low <= least;
    };
    if (wall.empty())
        return false;
    for (std::size_t i = 0; i < portal.points.size(); ++i) {
        const Vec3 edge = portal.points[i + 1 == portal.points.size() ? 0 : i + 1] - portal.points[i];
        if (glm::length(edge) > kOverlapTolerance && partedAlong(glm::normalize(edge)))
            return false;
    }
    return std::none_of(shape.edges.begin(), shape.edges.end(), partedAlong);
}

/// True if part of a cell is on the side of a portal's plane that the portal's own space is not on.
bool reachesBefore(const PortalContent& portal, const CellShape& shape) {
    return std::any_of(shape.points.begin(), shape.points.end(),
                       [&](const Vec3& p) { return portal.plane.signedDistance(p) < -kInPlaneTolerance; });
}

/// Cells by grid cell, so that only near cells are compared.
class CellGrid {
public:
    explicit CellGrid(const BlockContent& block) : block_(block) {}

    void add(std::uint32_t cell) {
        if (!forEachKey(block_.cells[cell].shape.bounds, [&](std::uint64_t key) {
                near_[key].push_back(cell);
                return true;
            }))
            large_.push_back(cell);
        all_.push_back(cell);
    }

    /// True if the test holds for all cells whose bounds can touch the box.
    template <class Test>
    [[nodiscard]] bool allNear(const Aabb& box, Test test) const {
        bool all = true;
        const bool small = forEachKey(box, [&](std::uint64_t key) {
            const auto found = near_.find(key);
            all = all &&
                  (found == near_.end() || std::all_of(found->second.begin(), found->second.end(), test));
            return all;
        });
        if (!small)
            return std::all_of(all_.begin(), all_.end(), test);
        return all && std::all_of(large_.begin(), large_.end(), test);
    }

private:
    static constexpr double kSide = 16.0; ///< metres
    static constexpr std::int64_t kMostKeys = 512;

    /// Calls `visit` for each grid cell of a box, until it returns false. A box that spans too many grid
    /// cells is not visited, and the result is false.
    template <class Visit>
    static bool forEachKey(const Aabb& box, Visit visit) {
        if (box.empty())
            return true; // a cell without points is in no grid cell
        const glm::i64vec3 low(glm::floor(box.min / kSide)), high(glm::floor(box.max / kSide));
        const glm::i64vec3 size = high - low + glm::i64vec3(1);
        if (box.empty() || size.x > kMostKeys || size.y > kMostKeys || size.z > kMostKeys ||
            size.x * size.y * size.z > kMostKeys)
            return false;
        for (std::int64_t x = low.x; x <= high.x; ++x) {
            for (std::int64_t y = low.y; y <= high.y; ++y) {
                for (std::int64_t z = low.z; z <= high.z; ++z) {
                    const auto part = [](std::int64_t v) {
                        return static_cast<std::uint64_t>(v + (1 << 20)) & 0x1FFFFF;
                    };
                    if (!visit(part(x) << 42 | part(y) << 21 | part(z)))
                        return true;
                }
            }
        }
        return true;
    }

    const BlockContent& block_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> near_;
    std::vector<std::uint32_t> large_, all_;
};

class ZoneGrower {
public:
    explicit ZoneGrower(const BlockContent& block)
        : block_(block), all_(block), overlaps_(block.cells.size()), zoneOf_(block.cells.size(), kNone),
          incoming_(block.cells.size()) {
        LIMEN_ASSERT(block.firstOutdoorPortal <= block.portals.size(), "the portals of cells come first");
        for (std::uint32_t cell = 0; cell < block.cells.size(); ++cell)
            all_.add(cell);
        for (std::uint32_t p = 0; p < block.firstOutdoorPortal; ++p) {
            const PortalContent& portal = block.portals[p];
            if (portal.destination < kOutdoorSpace && !joins(portal))
                incoming_[portal.destination].push_back(portal.space);
        }
    }

    std::vector<std::vector<std::uint32_t>> run() {
        for (std::uint32_t cell = 0; cell < block_.cells.size(); ++cell)
            if (zoneOf_[cell] == kNone)
                growFrom(cell);
        return std::move(zones_);
    }

private:
    [[nodiscard]] static bool joins(const PortalContent& portal) {
        return portal.exact && portal.reciprocal != kNone;
    }

    void growFrom(std::uint32_t first) {
        const auto zone = static_cast<std::uint32_t>(zones_.size());
        LIMEN_ASSERT(zoneOf_[first] == kNone, "a cell is in one zone");
        zones_.push_back({first});
        zoneOf_[first] = zone;
        if (!block_.cells[first].shape.closed)
            return;
        CellGrid members(block_);
        members.add(first);
        for (std::size_t i = 0; i < zones_[zone].size(); ++i) {
            const CellContent& cell = block_.cells[zones_[zone][i]];
            for (std::uint32_t p = cell.firstPortal; p < cell.firstPortal + cell.portalCount; ++p) {
                const PortalContent& portal = block_.portals[p];
                const std::uint32_t next = portal.destination;
                if (next >= kOutdoorSpace || !joins(portal) || zoneOf_[next] != kNone ||
                    !mayJoin(next, zone, members))
                    continue;
                zoneOf_[next] = zone;
                zones_[zone].push_back(next);
                members.add(next);
            }
        }
    }

    [[nodiscard]] bool mayJoin(std::uint32_t cell, std::uint32_t zone, const CellGrid& members) {
        const CellContent& content = block_.cells[cell];
        if (!content.shape.closed)
            return false;
        for (std::uint32_t p = content.firstPortal; p < content.firstPortal + content.portalCount; ++p) {
            const PortalContent& portal = block_.portals[p];
            if (portal.destination < kOutdoorSpace && !joins(portal) && zoneOf_[portal.destination] == zone)
                return false;
        }
        const bool entered = std::any_of(incoming_[cell].begin(), incoming_[cell].end(),
                                         [&](std::uint32_t from) { return zoneOf_[from] == zone; });
        return !entered && members.allNear(content.shape.bounds, [&](std::uint32_t member) {
            return areDisjoint(content.shape, block_.cells[member].shape) && !isMetAtOpenings(cell, member) &&
                   !isMetAtOpenings(member, cell);
        });
    }

    /// True if rays that come into another cell by an opening could meet walls of this cell, because surfaces in an opening's
    /// plane are met from both sides. This cell is right behind an opening that does not lead to it, or touches
    /// the opening from before; there, rays from a third cell in the same place pass it.
    [[nodiscard]] bool isMetAtOpenings(std::uint32_t cell, std::uint32_t other) {
        const CellContent& from = block_.cells[other];
        const CellShape& shape = block_.cells[cell].shape;
        for (std::uint32_t p = from.firstPortal; p < from.firstPortal + from.portalCount; ++p) {
            const PortalContent& portal = block_.portals[p];
            if (portal.destination == cell || !isNear(portal, shape.bounds))
                continue;
            if (hasWallIn(portal, shape, kOverlapTolerance) ||
                (hasWallIn(portal, shape, -kInPlaneTolerance) && reachesBefore(portal, shape) &&
                 overlapsAnother(cell)))
                return true;
        }
        return false;
    }

    /// True if a cell overlaps any other cell of the block.
    [[nodiscard]] bool overlapsAnother(std::uint32_t cell) {
        if (!overlaps_[cell]) {
            const CellShape& shape = block_.cells[cell].shape;
            overlaps_[cell] = !all_.allNear(shape.bounds, [&](std::uint32_t other) {
                return other == cell || areDisjoint(shape, block_.cells[other].shape);
            });
        }
        return *overlaps_[cell];
    }

    const BlockContent& block_;
    CellGrid all_;
    std::vector<std::optional<bool>> overlaps_; ///< by cell: as overlapsAnother
    std::vector<std::uint32_t> zoneOf_;
    std::vector<std::vector<std::uint32_t>>
        incoming_; ///< by cell: cells with a portal into it that does not join
    std::vector<std::vector<std::uint32_t>> zones_;
};

} // namespace

bool areDisjoint(const CellShape& a, const CellShape& b) {
    if (boxesPart(a.bounds, b.bounds))
        return true;
    if (a.points.size() > kMaxPoints || b.points.size() > kMaxPoints)
        return false;
    const auto partsAB = [&](const Vec3& axis) { return parts(a, b, axis); };
    if (std::any_of(a.normals.begin(), a.normals.end(), partsAB) ||
        std::any_of(b.normals.begin(), b.normals.end(), partsAB))
        return true;
    for (const Vec3& e : a.edges) {
        for (const Vec3& f : b.edges) {
            const Vec3 axis = glm::cross(e, f);
            const double length = glm::length(axis);
            if (length > 1e-4 && partsAB(axis / length))
                return true;
        }
    }
    return false;
}

std::vector<std::vector<std::uint32_t>> groupIntoZones(const BlockContent& block, bool merge) {
    if (merge)
        return ZoneGrower(block).run();
    std::vector<std::vector<std::uint32_t>> zones;
    for (std::uint32_t cell = 0; cell < block.cells.size(); ++cell)
        zones.push_back({cell});
    return zones;
}

} // namespace limen::world
