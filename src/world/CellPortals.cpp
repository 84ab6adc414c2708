#include "world/CellPortals.h"

#include "geometry/ConvexPolygon.h"

#include <algorithm>

namespace limen::world {
namespace {

/// How far a portal's corners may lie off its plane, or inside the hull of the others; metres. Stitching
/// moves them by less than the weld tolerance.
constexpr double kFlatness = 0.001;
/// How far a shell may reach through a portal's plane and still count as on one side; metres.
constexpr double kOneSided = 0.01;

/// Why a polygon cannot be an opening, or null.
const char* defectOf(std::span<const Vec3> polygon) {
    const Plane plane = planeOf(polygon);
    if (plane.n == Vec3(0.0) || glm::length(newellNormal(polygon)) < 2e-6)
        return "has no area";
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3& a = polygon[i];
        const Vec3& b = polygon[(i + 1) % polygon.size()];
        if (!(std::abs(plane.signedDistance(a)) <= kFlatness))
            return "is not flat";
        const Vec3 inward = glm::normalize(glm::cross(plane.n, b - a));
        for (const Vec3& p : polygon) {
            if (glm::dot(inward, p - a) < -kFlatness)
                return "is not convex";
        }
    }
    return nullptr;
}

/// +1: all points in front of the plane, -1: all behind, 0: both or neither.
int sideOf(const Plane& plane, std::span<const Vec3> points) {
    double least = 0.0, most = 0.0;
    for (const Vec3& p : points) {
        least = std::min(least, plane.signedDistance(p));
        most = std::max(most, plane.signedDistance(p));
    }
    if (least >= -kOneSided && most > kOneSided)
        return 1;
    return most <= kOneSided && least < -kOneSided ? -1 : 0;
}

/// Fills in points and plane. Yields what is wrong with the polygon, or null.
const char* shapePortal(PortalContent& portal, std::uint32_t handle, const BlockGeometry& geometry,
                        CellClosure& closure, std::span<const Vec3> shellPoints, bool& contradicts) {
    if (handle == kNone)
        return "does not exist";
    if (geometry.loops(handle).size() != 1)
        return "has no area";
    const StitchLoop& loop = geometry.loops(handle).front();
    std::vector<Vec3> points;
    for (const StitchCorner& corner : loop)
        points.emplace_back(geometry.vertices()[corner.vertex]);
    const Plane plane = planeOf(points);
    const bool flagged = (portal.flags & dat::CellPortal::kPortalSide) != 0;
    int side = closure.fit(loop);
    if (side == 0)
        side = sideOf(plane, shellPoints);
    const bool positive = side != 0 ? side > 0 : flagged;
    contradicts = positive != flagged;
    closure.addPortal(loop, !positive);
    if (const char* defect = defectOf(points))
        return defect;
    if (!positive)
        std::reverse(points.begin(), points.end());
    portal.points.assign(points.begin(), points.end());
    portal.plane = positive ? plane : plane.flipped();
    return nullptr;
}

} // namespace

std::vector<PortalContent> cellPortals(const CellDraft& draft, std::uint32_t cell,
                                       const BlockGeometry& geometry, CellClosure& closure,
                                       std::span<const Vec3> shellPoints, std::vector<Finding>& findings) {
    std::vector<PortalContent> portals;
    for (std::size_t i = 0; i < draft.portals.size(); ++i) {
        const dat::CellPortal& record = draft.record.portals[i];
        PortalContent portal;
        portal.space = cell;
        portal.recordIndex = static_cast<std::uint16_t>(i);
        portal.polygonId = record.polygonId;
        portal.flags = record.flags;
        portal.otherCell = record.otherCellId;
        portal.otherPortal = record.otherPortalId;
        bool contradicts = false;
        if (const char* defect =
                shapePortal(portal, draft.portals[i], geometry, closure, shellPoints, contradicts))
            note(findings, draft.record.id,
                 "the polygon of portal " + std::to_string(i) + " " + defect + "; it stays shut");
        else if (contradicts)
            note(findings, draft.record.id,
                 "portal " + std::to_string(i) + " is flagged to lie on the wrong side of its cell");
        portals.push_back(std::move(portal));
    }
    return portals;
}

} // namespace limen::world
