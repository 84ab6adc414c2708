#include "visibility/ZoneCheck.h"

#include "geometry/Tolerances.h"
#include "visibility/OpeningMatch.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <vector>

namespace limen::visibility {

namespace {

/// A portal or a wall of a space in a zone of several spaces.
struct ZoneSide {
    std::uint32_t zone = 0, space = 0;
    std::uint32_t portal = kNone; ///< kNone: a wall
    std::span<const Vec3> polygon;
    Aabb box;
    bool leadsOut = false; ///< a portal out of the zone
};

std::string portalName(const Graph& graph, std::uint32_t portal) {
    const Graph::Portal& p = graph.portals()[portal];
    const std::string end =
        p.destination == kNone ? " to nowhere" : " to space " + std::to_string(p.destination);
    return "portal " + std::to_string(portal) + ", from space " + std::to_string(p.space) + end;
}

Result<void> checkWalls(const Graph& graph, std::span<const WallDesc> walls, std::span<const Vec3> vertices) {
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const WallDesc& wall = walls[i];
        const std::string where = "wall " + std::to_string(i);
        if (wall.space >= graph.spaces().size())
            return fail(ErrorCode::BadArgument, where, "names a space that does not exist");
        if (wall.firstVertex > vertices.size() || wall.vertexCount > vertices.size() - wall.firstVertex)
            return fail(ErrorCode::BadArgument, where, "has vertices outside the array");
        const auto polygon = vertices.subspan(wall.firstVertex, wall.vertexCount);
        if (!std::all_of(polygon.begin(), polygon.end(), [](const Vec3& v) { return isFinite(v); }))
            return fail(ErrorCode::BadArgument, where, "has a vertex that is not finite");
    }
    return {};
}

/// The number of spaces in each zone.
std::map<std::uint32_t, std::uint32_t> sizesOf(const Graph& graph) {
    std::map<std::uint32_t, std::uint32_t> sizes;
    for (const Graph::Space& space : graph.spaces())
        ++sizes[space.zone];
    return sizes;
}

Result<void> checkPairs(const Graph& graph) {
    for (std::uint32_t i = 0; i < graph.portals().size(); ++i) {
        const Graph::Portal& portal = graph.portals()[i];
        if (!portal.withinZone || (portal.exact && portal.reciprocal != kNone))
            continue;
        return fail(
            ErrorCode::BadArgument, portalName(graph, i),
            std::string("leads to a space of the same zone, and ") +
                (portal.reciprocal == kNone ? "has no reciprocal" : "its reciprocal has another polygon") +
                "; give the two spaces different zones");
    }
    return {};
}

/// Spaces that are joined by portals within zones, also by portals without area, as trees of space numbers.
class Joined {
public:
    explicit Joined(const Graph& graph) : above_(graph.spaces().size()) {
        std::iota(above_.begin(), above_.end(), 0u);
        const auto zoneOf = [&](std::uint32_t space) { return graph.spaces()[space].zone; };
        for (const Graph::Portal& portal : graph.portals())
            if (portal.destination != kNone && zoneOf(portal.space) == zoneOf(portal.destination))
                above_[top(portal.space)] = top(portal.destination);
    }
    std::uint32_t top(std::uint32_t space) {
        while (above_[space] != space)
            space = above_[space] = above_[above_[space]];
        return space;
    }

private:
    std::vector<std::uint32_t> above_;
};

Result<void> checkConnected(const Graph& graph) {
    Joined joined(graph);
    std::map<std::uint32_t, std::uint32_t> firstOf; ///< by zone
    for (std::uint32_t i = 0; i < graph.spaces().size(); ++i) {
        const std::uint32_t zone = graph.spaces()[i].zone;
        const std::uint32_t first = firstOf.emplace(zone, i).first->second;
        if (joined.top(i) != joined.top(first))
            return fail(ErrorCode::BadArgument, "space " + std::to_string(i),
                        "is in one zone with space " + std::to_string(first) +
                            ", but no portals within the zone connect them; give it a zone of its own");
    }
    return {};
}

std::vector<ZoneSide> zoneSidesOf(const Graph& graph, std::span<const WallDesc> walls,
                                  std::span<const Vec3> vertices) {
    const auto sizes = sizesOf(graph);
    std::vector<ZoneSide> sides;
    const auto add = [&](ZoneSide side) {
        side.zone = graph.spaces()[side.space].zone;
        if (sizes.at(side.zone) < 2 || side.polygon.size() < 3)
            return;
        for (const Vec3& corner : side.polygon)
            side.box.include(corner);
        sides.push_back(side);
    };
    for (std::uint32_t i = 0; i < graph.portals().size(); ++i) {
        const Graph::Portal& p = graph.portals()[i];
        const bool leadsOut = p.plane.n != Vec3(0.0) && !p.withinZone && p.destination != p.space;
        add({0, p.space, i, graph.polygon(p), {}, leadsOut});
    }
    for (const WallDesc& wall : walls)
        add({0, wall.space, kNone, vertices.subspan(wall.firstVertex, wall.vertexCount), {}, false});
    return sides;
}

int longestAxisOf(std::span<const ZoneSide> sides) {
    Aabb all;
    for (const ZoneSide& side : sides)
        all.include(side.box);
    const Vec3 size = all.max - all.min;
    return size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
}

bool isRightBehind(const Graph& graph, const ZoneSide& side, const ZoneSide& opening) {
    if (!opening.leadsOut || side.zone != opening.zone || side.space == opening.space)
        return false;
    for (int axis = 0; axis < 3; ++axis)
        if (side.box.min[axis] > opening.box.max[axis] + kInPlaneTolerance ||
            opening.box.min[axis] > side.box.max[axis] + kInPlaneTolerance)
            return false;
    return overlapsInPlane(side.polygon, opening.polygon, graph.portals()[opening.portal].plane,
                           kInPlaneTolerance, kOverlapTolerance);
}

Result<void> refuseZone(const Graph& graph, const ZoneSide& side, const ZoneSide& opening) {
    const std::string part = side.portal == kNone ? "a wall" : "portal " + std::to_string(side.portal);
    return fail(ErrorCode::BadArgument, portalName(graph, opening.portal),
                "leads out of the zone, and " + part + " of space " + std::to_string(side.space) +
                    ", which is in the same zone, is right behind it; give space " +
                    std::to_string(side.space) + " a zone of its own");
}

/// Compares sides whose boxes overlap along the longest axis.
Result<void> checkBehind(const Graph& graph, std::vector<ZoneSide> sides) {
    const int axis = longestAxisOf(sides);
    std::sort(sides.begin(), sides.end(),
              [&](const ZoneSide& a, const ZoneSide& b) { return a.box.min[axis] < b.box.min[axis]; });
    for (std::size_t a = 0; a < sides.size(); ++a) {
        for (std::size_t b = a + 1; b < sides.size(); ++b) {
            if (sides[b].box.min[axis] > sides[a].box.max[axis] + kInPlaneTolerance)
                break;
            if (isRightBehind(graph, sides[b], sides[a]))
                return refuseZone(graph, sides[b], sides[a]);
            if (isRightBehind(graph, sides[a], sides[b]))
                return refuseZone(graph, sides[a], sides[b]);
        }
    }
    return {};
}

} // namespace

Result<void> checkZones(const Graph& graph, std::span<const WallDesc> walls, std::span<const Vec3> vertices) {
    if (Result<void> good = checkWalls(graph, walls, vertices); !good)
        return good;
    if (Result<void> paired = checkPairs(graph); !paired)
        return paired;
    if (Result<void> connected = checkConnected(graph); !connected)
        return connected;
    return checkBehind(graph, zoneSidesOf(graph, walls, vertices));
}

} // namespace limen::visibility
