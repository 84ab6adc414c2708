#include "world/block/BentOpenings.h"

#include "core/Assert.h"
#include "geometry/Segment.h"
#include "world/block/OpeningOverlay.h"
#include "world/mesh/Triangulate.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace limen::world {
namespace {

/// Four half steps of a float, as a share of the distance from a cell's origin. Vertices that are off by less leave an opening
/// in one piece. An eye nearer to its plane can be past the edges of the walls beside it (decision 210).
constexpr double kBentShare = 4.0 / (1 << 24);
constexpr double kLeastBent = 1e-6; ///< metres, near the origin

/// Metres from the origin of a cell's record to the farthest vertex; 0 for the outside.
double reachFrom(const BlockContent& block, std::uint32_t space, std::span<const Vec3> points) {
    double reach = 0.0;
    if (space < block.cells.size())
        for (const Vec3& point : points)
            reach = std::max(reach, glm::length(point - block.cells[space].origin));
    return reach;
}

/// The deviation that the records of both cells may have by rounding, metres.
double roundingOf(const BlockContent& block, const PortalContent& portal) {
    const double reach = std::max(reachFrom(block, portal.space, portal.points),
                                  reachFrom(block, portal.destination, portal.points));
    return std::max(kLeastBent, kBentShare * reach);
}

/// Whether a vertex of the outline is off the plane, or a stitched one off the edge that it was stitched into.
bool isBent(const PortalContent& portal, double most) {
    const std::vector<Vec3>& hull = portal.corners;
    return std::any_of(portal.points.begin(), portal.points.end(), [&](const Vec3& point) {
        double off = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < hull.size(); ++i)
            off = std::min(off, distanceToSegment(point, hull[i], hull[(i + 1) % hull.size()]).distance);
        return off > most || std::abs(portal.plane.signedDistance(point)) > most;
    });
}

/// For each vertex of `a` the number of the same vertex of `b`: welding has made them equal to the bit. Empty if the
/// polygons have other vertices.
std::vector<std::uint32_t> sameVertices(const PortalContent& a, const PortalContent& b) {
    std::vector<std::uint32_t> same;
    if (a.points.size() != b.points.size())
        return {};
    for (const Vec3& point : a.points) {
        const auto at = std::find(b.points.begin(), b.points.end(), point);
        if (at == b.points.end())
            return {};
        same.push_back(static_cast<std::uint32_t>(at - b.points.begin()));
    }
    return same;
}

using TrianglePoints = std::array<Vec3, 3>;

TrianglePoints turned(const TrianglePoints& triangle) {
    return {triangle[2], triangle[1], triangle[0]};
}

/// None if a loop cannot be triangulated.
std::optional<std::vector<TrianglePoints>> trianglesOf(std::span<const OpeningOverlay::Loop> loops,
                                                       const Vec3& normal) {
    std::vector<TrianglePoints> triangles;
    std::vector<TriangleCorners> corners;
    for (const OpeningOverlay::Loop& loop : loops) {
        corners.clear();
        triangulate(loop, normal, corners);
        if (corners.size() + 2 != loop.size())
            return std::nullopt;
        for (const auto& [i, j, k] : corners)
            triangles.push_back({loop[i], loop[j], loop[k]});
    }
    return triangles;
}

/// The triangles of an inexact pair, counter-clockwise seen from the first portal's space.
struct PairTriangles {
    std::vector<TrianglePoints> common, first, second;
};

/// None if the outlines have no part in common, or no triangles.
std::optional<PairTriangles> trianglesOfPair(const PortalContent& front, const PortalContent& back) {
    const std::vector<Vec3> reversed(back.points.rbegin(), back.points.rend());
    const Vec3& normal = front.plane.n;
    const std::optional<OpeningOverlay> parts = overlayOpenings(front.points, reversed, normal);
    if (!parts)
        return std::nullopt;
    auto common = trianglesOf(parts->common, normal), first = trianglesOf(parts->first, normal),
         second = trianglesOf(parts->second, normal);
    if (!common || !first || !second)
        return std::nullopt;
    return PairTriangles{std::move(*common), std::move(*first), std::move(*second)};
}

PortalContent partOf(const PortalContent& whole, const TrianglePoints& triangle) {
    PortalContent part = whole;
    part.points.assign(triangle.begin(), triangle.end());
    part.corners = part.points;
    part.plane = planeOf(part.points);
    part.exact = true;
    return part;
}

/// A part that only one polygon of an inexact pair has: rays that pass it meet a hole.
PortalContent holeOf(const PortalContent& whole, const TrianglePoints& triangle) {
    PortalContent part = partOf(whole, triangle);
    part.destination = part.reciprocal = kNone;
    return part;
}

/// The portals of a block while some are replaced by their parts.
class Splitting {
public:
    explicit Splitting(BlockContent& block) : block_(block), parts_(block.portals.size()) {}

    /// A portal without a way back.
    void split(std::uint32_t portal) {
        const PortalContent& whole = block_.portals[portal];
        for (const auto& [i, j, k] : trianglesOf(whole))
            parts_[portal].push_back(partOf(whole, {whole.points[i], whole.points[j], whole.points[k]}));
    }

    /// Both portals of a pair get parts of equal numbers.
    void split(std::uint32_t a, std::uint32_t b) {
        const PortalContent &front = block_.portals[a], &back = block_.portals[b];
        const std::vector<std::uint32_t> same = sameVertices(front, back);
        if (same.empty())
            return;
        for (const auto& [i, j, k] : trianglesOf(front)) {
            parts_[a].push_back(partOf(front, {front.points[i], front.points[j], front.points[k]}));
            parts_[b].push_back(
                partOf(back, {back.points[same[k]], back.points[same[j]], back.points[same[i]]}));
        }
    }

    /// Both portals of an inexact pair: pairs of equal triangles where both are, then holes where one is.
    void splitInexact(std::uint32_t a, std::uint32_t b) {
        const PortalContent &front = block_.portals[a], &back = block_.portals[b];
        const std::optional<PairTriangles> triangles = trianglesOfPair(front, back);
        if (!triangles)
            return;
        for (const TrianglePoints& triangle : triangles->common) {
            parts_[a].push_back(partOf(front, triangle));
            parts_[b].push_back(partOf(back, turned(triangle)));
        }
        for (const TrianglePoints& triangle : triangles->first)
            parts_[a].push_back(holeOf(front, triangle));
        for (const TrianglePoints& triangle : triangles->second)
            parts_[b].push_back(holeOf(back, turned(triangle)));
    }

    void finish() {
        std::vector<std::uint32_t> first{0}; // by old portal: its new index
        for (const std::vector<PortalContent>& parts : parts_)
            first.push_back(first.back() +
                            static_cast<std::uint32_t>(std::max<std::size_t>(parts.size(), 1)));
        std::vector<PortalContent> portals;
        portals.reserve(first.back());
        for (std::size_t p = 0; p < parts_.size(); ++p)
            replace(block_.portals[p], parts_[p], first, portals);
        block_.portals = std::move(portals);
        for (CellContent& cell : block_.cells) {
            const std::uint32_t end = first[cell.firstPortal + cell.portalCount];
            cell.firstPortal = first[cell.firstPortal];
            cell.portalCount = end - cell.firstPortal;
        }
        block_.firstOutdoorPortal = first[block_.firstOutdoorPortal];
    }

private:
    /// None: the portal stays whole.
    [[nodiscard]] static std::vector<TriangleCorners> trianglesOf(const PortalContent& portal) {
        std::vector<TriangleCorners> triangles;
        triangulate(portal.points, triangles);
        if (triangles.size() < 2 || triangles.size() > std::numeric_limits<std::uint16_t>::max())
            triangles.clear();
        return triangles;
    }

    void replace(PortalContent& portal, std::vector<PortalContent>& parts,
                 const std::vector<std::uint32_t>& first, std::vector<PortalContent>& portals) {
        const std::uint32_t way = portal.reciprocal == kNone ? kNone : first[portal.reciprocal];
        if (parts.empty()) {
            portals.push_back(std::move(portal));
            portals.back().reciprocal = way;
            return;
        }
        for (std::uint32_t i = 0; i < parts.size(); ++i) {
            const bool hasWay = way != kNone && parts[i].reciprocal != kNone;
            parts[i].reciprocal = hasWay ? way + i : kNone;
            parts[i].part = static_cast<std::uint16_t>(i);
            parts[i].partCount = static_cast<std::uint16_t>(parts.size());
            parts[i].whole = static_cast<std::uint32_t>(block_.wholes.size());
            portals.push_back(std::move(parts[i]));
        }
        portal.reciprocal = kNone;
        block_.wholes.push_back(std::move(portal));
    }

    BlockContent& block_;
    std::vector<std::vector<PortalContent>> parts_; ///< by portal; empty: it stays whole
};

} // namespace

void splitBentOpenings(BlockContent& block) {
    Splitting splitting(block);
    for (std::uint32_t p = 0; p < block.portals.size(); ++p) {
        const PortalContent& portal = block.portals[p];
        if (portal.reciprocal < p || portal.walled || portal.points.size() < (portal.exact ? 4 : 3))
            continue;
        const bool isOneWay = portal.reciprocal == kNone;
        LIMEN_ASSERT(isOneWay || block.portals[portal.reciprocal].reciprocal == p,
                     "the way back of a way back is the portal itself");
        const double most = roundingOf(block, portal);
        if (isOneWay && isBent(portal, most))
            splitting.split(p);
        else if (!isOneWay && (isBent(portal, most) || isBent(block.portals[portal.reciprocal], most)))
            portal.exact ? splitting.split(p, portal.reciprocal)
                         : splitting.splitInexact(p, portal.reciprocal);
    }
    splitting.finish();
}

} // namespace limen::world
