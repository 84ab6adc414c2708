#include "world/block/BentOpenings.h"

#include "core/Assert.h"
#include "geometry/Segment.h"
#include "world/mesh/Triangulate.h"

#include <algorithm>
#include <limits>

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

PortalContent partOf(const PortalContent& whole, const TriangleCorners& corner) {
    PortalContent part = whole;
    part.points = {whole.points[corner[0]], whole.points[corner[1]], whole.points[corner[2]]};
    part.corners = part.points;
    part.plane = planeOf(part.points);
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
            parts_[portal].push_back(partOf(whole, {i, j, k}));
    }

    /// Both portals of a pair get parts of equal numbers.
    void split(std::uint32_t a, std::uint32_t b) {
        const PortalContent &front = block_.portals[a], &back = block_.portals[b];
        const std::vector<std::uint32_t> same = sameVertices(front, back);
        if (same.empty())
            return;
        for (const auto& [i, j, k] : trianglesOf(front)) {
            parts_[a].push_back(partOf(front, {i, j, k}));
            parts_[b].push_back(partOf(back, {same[k], same[j], same[i]}));
        }
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
            parts[i].reciprocal = way == kNone ? kNone : way + i;
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
        if (portal.reciprocal < p || !portal.exact || portal.walled || portal.points.size() < 4)
            continue;
        const bool isOneWay = portal.reciprocal == kNone;
        LIMEN_ASSERT(isOneWay || block.portals[portal.reciprocal].reciprocal == p,
                     "the way back of a way back is the portal itself");
        const double most = roundingOf(block, portal);
        if (isOneWay && isBent(portal, most))
            splitting.split(p);
        else if (!isOneWay && (isBent(portal, most) || isBent(block.portals[portal.reciprocal], most)))
            splitting.split(p, portal.reciprocal);
    }
    splitting.finish();
}

} // namespace limen::world
