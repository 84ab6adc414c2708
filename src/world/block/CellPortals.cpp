#include "world/block/CellPortals.h"

#include "core/Assert.h"
#include "geometry/ConvexPolygon.h"
#include "geometry/Segment.h"

#include <algorithm>

namespace limen::world {
namespace {

/// Metres. The tolerated distance of a portal's corners from its plane, and from the hull of the other
/// corners. Stitching moves corners by less than the weld tolerance.
constexpr double kFlatness = 0.004;
/// Metres. A shell that reaches through a portal's plane by less than this counts as being on one side.
constexpr double kOneSided = 0.01;

/// The convex hull of a flat polygon, counter-clockwise seen from the tip of `normal`, without corners on its
/// edges. Ref: Andrew's monotone chain, 1979.
std::vector<Vec3> hullOf(std::vector<Vec3> points, const Vec3& normal) {
    const Vec3 helper = std::abs(normal.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 u = glm::normalize(glm::cross(helper, normal)), v = glm::cross(normal, u);
    const auto flat = [&](const Vec3& p) { return Vec2(glm::dot(p, u), glm::dot(p, v)); };
    std::sort(points.begin(), points.end(), [&](const Vec3& p, const Vec3& q) {
        const Vec2 a = flat(p), b = flat(q);
        return a.x != b.x ? a.x < b.x : a.y < b.y;
    });
    std::vector<Vec3> hull;
    const auto turnsLeft = [&](const Vec3& next) {
        const Vec2 a = flat(hull[hull.size() - 2]), b = flat(hull.back()), c = flat(next);
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0.0;
    };
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t first = hull.size();
        for (const Vec3& p : points) {
            while (hull.size() >= first + 2 && !turnsLeft(p))
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back(); // the other half starts with this corner
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

/// The reason why a polygon cannot be an opening, or null. `outline` is its convex hull.
const char* defectOf(std::span<const Vec3> polygon, std::span<const Vec3> outline, const Plane& plane) {
    if (outline.size() < 3 || glm::length(newellNormal(outline)) < 2e-6)
        return "has no area";
    for (const Vec3& p : polygon) {
        if (!(std::abs(plane.signedDistance(p)) <= kFlatness))
            return "is not flat";
        double depth = 1e300;
        for (std::size_t i = 0; i < outline.size(); ++i)
            depth =
                std::min(depth, distanceToSegment(p, outline[i], outline[(i + 1) % outline.size()]).distance);
        if (depth > kFlatness)
            return "is not convex";
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

/// Whether the polygon is an opaque surface on the side that faces the cell.
bool isWalled(const SourcePolygon& source, bool positive, std::span<const SurfaceList> lists) {
    const std::int32_t slot = positive ? source.frontSlot : source.backSlot;
    return slot >= 0 && lists[static_cast<std::size_t>(slot)] == SurfaceList::Opaque;
}

/// Sets the points, corners and plane. Yields the defect of the polygon, or null. `contradicts`: the record's
/// flag is wrong.
const char* shapePortal(PortalContent& portal, std::uint32_t handle, const CellGeometry& of,
                        CellClosure& closure, std::span<const Vec3> shellPoints, bool& contradicts) {
    const BakedGeometry& geometry = of.baked;
    if (handle == kNone)
        return "does not exist";
    if (geometry.loops(handle).size() != 1)
        return "has no area";
    const StitchLoop& loop = geometry.loops(handle).front();
    std::vector<Vec3> corners, points;
    for (const std::uint32_t vertex : geometry.corners(handle)) {
        const auto isHere = [&](const StitchCorner& corner) { return corner.vertex == vertex; };
        if (std::any_of(loop.begin(), loop.end(), isHere)) // stitching leaves out the tip of a spike
            corners.push_back(geometry.vertices()[vertex]);
    }
    for (const StitchCorner& corner : loop)
        points.push_back(geometry.vertices()[corner.vertex]);
    const Plane plane = planeOf(corners);
    const bool flagged = (portal.flags & dat::CellPortal::kPortalSide) != 0;
    int side = closure.fit(loop);
    if (side == 0)
        side = sideOf(plane, shellPoints);
    const bool positive = side != 0 ? side > 0 : flagged;
    contradicts = positive != flagged;
    portal.walled = isWalled(geometry.source(handle), positive, of.lists);
    closure.addPortal(loop, !positive);
    if (plane.n == Vec3(0.0))
        return "has no area";
    portal.plane = positive ? plane : plane.flipped();
    std::vector<Vec3> hull = hullOf(corners, portal.plane.n);
    if (const char* defect = defectOf(corners, hull, plane))
        return defect;
    portal.plane = planeOf(hull); // of the corners that count: the flood has these only
    if (!positive)
        std::reverse(points.begin(), points.end());
    portal.points = std::move(points);
    portal.corners = std::move(hull);
    return nullptr;
}

} // namespace

std::vector<PortalContent> cellPortals(const CellDraft& draft, std::uint32_t cell,
                                       const CellGeometry& geometry, CellClosure& closure,
                                       std::span<const Vec3> shellPoints, std::vector<Finding>& findings) {
    LIMEN_ASSERT(draft.portals.size() == draft.record.portals.size(), "one handle for each portal");
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
                 "portal " + std::to_string(i) + " is flagged as being on the wrong side of its cell");
        portals.push_back(std::move(portal));
    }
    return portals;
}

} // namespace limen::world
