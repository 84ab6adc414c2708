#include "frame/Ownership.h"

#include "geometry/ConvexPolygon.h"
#include "geometry/Tolerances.h"
#include "geometry/TwoFloats.h"
#include "visibility/Graph.h"

#include <algorithm>

namespace limen::frame {

namespace {

/// Openings nearer to the eye than this, in metres, are looked for in the whole window: in float, the corners of a polygon
/// that close lie so far off the screen that the rasteriser's own cuts are no longer exact.
constexpr double kNearOpening = 0.05;

/// Pixels by which a parent's edges are moved outwards. The edges are exact, but the parent was drawn with snapped
/// corners: the child must not lose a pixel that the parent owns. With a larger growth the child takes pixels beside
/// a thin jamb that its parent does not own, and surfaces behind the parent's plane show there.
constexpr double kGrowth = kSnapTolerance;

/// Edges that fit a clip set beside the entry plane: GL guarantees eight clip distances.
constexpr std::size_t kEdgesPerSet = 7;

class OwnershipPlanner {
public:
    OwnershipPlanner(const world::World& world, const world::DynamicState& dynamics, const FrameView& frame,
                     const visibility::VisibleSet& set, FramePlan& plan)
        : world_(world), dynamics_(dynamics), frame_(frame), set_(set), plan_(plan),
          screen_(frame.view.screenFromEye()) {}

    void run() {
        plan_.clipSets.push_back(openClipSet());
        for (std::uint32_t i = 0; i < set_.visits.size(); ++i) {
            const visibility::Visit& visit = set_.visits[i];
            addVisit(visit);
            if (visit.depth == 0 || !frame_.rules.ownership)
                continue;
            // The flood's region of these is not what their outline and their parent's region leave of it.
            const bool byRegion = visit.split || isEdgeOn(visit) || visit.narrowed;
            if (byRegion) {
                drawWithin(i, set_.region(visit), Cut{0.0, {0, 0, 0, 1}});
            } else if (set_.visits[visit.parent].depth > 0 && frame_.rules.ancestorClip) {
                const visibility::Visit& parent = set_.visits[visit.parent];
                drawWithin(i, set_.region(parent),
                           Cut{frame_.rules.growth ? kGrowth : 0.0, planeFor(i, parent.entryPlane)});
            } else {
                draw(i, 0);
            }
        }
    }

private:
    /// How an opening is cut to a region: its edges moved outwards by so many pixels, and behind a plane.
    struct Cut {
        double growth = 0.0;
        gpu::vec4 plane{0, 0, 0, 1};
    };

    /// Whether floats may put the eye on the wrong side of the opening, though it is in its plane or before it: the flood's
    /// region, of doubles, is then all there is to go by. Nobody sees by how much less it shares its edges with the walls': it
    /// is half of all directions, or so thin that it holds few pixels if any.
    [[nodiscard]] static bool isEdgeOn(const visibility::Visit& visit) {
        return visit.inPlane || std::abs(visit.entryPlane.d) < kBeforePlaneTolerance;
    }

    void addVisit(const visibility::Visit& visit) {
        gpu::Visit out;
        const bool root = visit.depth == 0;
        out.entryPlane =
            root ? gpu::vec4(0, 0, 0, 1) : gpu::vec4(Vec3f(visit.entryPlane.n), visit.entryPlane.d);
        out.zone = visit.zone;
        out.parent = root ? gpu::kNoVisit : visit.parent;
        out.shutBy = visit.shut ? shutBy(visit.portal) : 0;
        plan_.visits.push_back(out);
    }

    /// gpu::Visit::shutBy of a shut portal.
    [[nodiscard]] std::uint32_t shutBy(std::uint32_t portal) const {
        const world::InstanceIndex filling =
            dynamics_.fillings.empty() ? world::kNone : dynamics_.fillings[portal];
        return filling == world::kNone ? gpu::kShutByNothing : dynamics_.instances[filling].idBase;
    }

    /// A plane to cut the visit's portal by; open where it does not reach: of a polygon seen edge-on the depth in the
    /// plane is told too roughly to be asked about for nothing.
    [[nodiscard]] gpu::vec4 planeFor(std::uint32_t visit, const Plane& entry) const {
        const auto polygon = polygonOf(world_, world_.portals[set_.visits[visit].portal]);
        const bool cuts = std::any_of(polygon.begin(), polygon.end(), [&](const Vec3& corner) {
            return entry.signedDistance(corner - frame_.view.eye) < -kEntryPlaneTolerance;
        });
        return cuts ? gpu::vec4(Vec3f(entry.n), entry.d + kEntryPlaneTolerance) : gpu::vec4(0, 0, 0, 1);
    }

    [[nodiscard]] bool isNear(const world::Portal& portal) const {
        if (!frame_.rules.nearOpening)
            return false;
        const Vec3& eye = frame_.view.eye;
        const auto polygon = std::span(world_.portalVertices).subspan(portal.firstVertex, portal.vertexCount);
        return std::abs(portal.plane.signedDistance(eye)) < kNearOpening &&
               containsProjection(polygon, portal.plane.n, eye, kNearOpening);
    }

    [[nodiscard]] static gpu::ClipSet openClipSet() {
        gpu::ClipSet open;
        for (gpu::vec4& plane : open.planes)
            plane = {0, 0, 0, 1};
        return open;
    }

    /// The plane through the eye and one edge of a region, moved outwards by some pixels, eye-relative.
    [[nodiscard]] gpu::vec4 edgePlane(const Vec3& a, const Vec3& b, double growth) const {
        Vec3 edge = glm::cross(a, b);
        edge.z += growth * (std::abs(edge.x) * 2.0 / frame_.width + std::abs(edge.y) * 2.0 / frame_.height);
        const Vec3 n = glm::transpose(screen_) * edge;
        const double length = std::sqrt(glm::dot(n, n));
        return length > 0.0 ? gpu::vec4(Vec3f(n / length), 0.0f) : gpu::vec4(0, 0, 0, 1);
    }

    /// A region with more edges than fit is cut into fans around its first vertex, each drawn for itself; the fans' inner
    /// edges are always moved, so that they overlap rather than gape.
    void drawWithin(std::uint32_t visit, std::span<const Vec3> region, const Cut& cut) {
        for (std::size_t first = 1; first + 1 < region.size(); first += kEdgesPerSet - 2) {
            const std::size_t last = std::min(first + kEdgesPerSet - 2, region.size() - 1);
            gpu::ClipSet clip = openClipSet();
            std::size_t slot = 0;
            clip.planes[slot++] = edgePlane(region[0], region[first], first == 1 ? cut.growth : kGrowth);
            for (std::size_t i = first; i < last; ++i)
                clip.planes[slot++] = edgePlane(region[i], region[i + 1], cut.growth);
            clip.planes[slot++] =
                edgePlane(region[last], region[0], last + 1 == region.size() ? cut.growth : kGrowth);
            clip.planes[kEdgesPerSet] = cut.plane;
            plan_.clipSets.push_back(clip);
            draw(visit, static_cast<std::uint32_t>(plan_.clipSets.size() - 1));
        }
    }

    void draw(std::uint32_t visit, std::uint32_t clipSet) {
        if (isEdgeOn(set_.visits[visit]))
            drawEverywhere(visit, clipSet);
        else
            drawPortal(visit, clipSet);
    }

    void drawEverywhere(std::uint32_t visit, std::uint32_t clipSet) {
        const auto first = static_cast<std::uint32_t>(plan_.ownershipVertices.size());
        plan_.ownershipVertices.insert(
            plan_.ownershipVertices.end(), 3,
            {Vec3f(0.0f), 0, visit, clipSet, first, gpu::kCoverWindow, Vec3f(0.0f), 0});
    }

    /// The portal polygon as a fan around its middle: every edge of its outline stays as it is, divided
    /// exactly where the walls' are.
    void drawPortal(std::uint32_t visit, std::uint32_t clipSet) {
        const world::Portal& portal = world_.portals[set_.visits[visit].portal];
        const Vec3 origin = world_.blocks[portal.block].origin();
        const auto polygon = std::span(world_.portalVertices).subspan(portal.firstVertex, portal.vertexCount);
        Vec3 middle(0.0);
        for (const Vec3& v : polygon)
            middle += (v - origin) / static_cast<double>(polygon.size());
        const auto first = static_cast<std::uint32_t>(plan_.ownershipVertices.size());
        const std::uint32_t count = portal.vertexCount | (isNear(portal) ? gpu::kCoverWindow : 0u);
        const auto corner = [&](const Vec3& local) {
            const TwoFloats parts = inTwoFloats(local); // the same as the walls'
            plan_.ownershipVertices.push_back(
                {parts.nearest, portal.block, visit, clipSet, first, count, parts.rest, 0});
        };
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            corner(middle);
            corner(polygon[i] - origin);
            corner(polygon[(i + 1) % polygon.size()] - origin);
        }
    }

    const world::World& world_;
    const world::DynamicState& dynamics_;
    const FrameView& frame_;
    const visibility::VisibleSet& set_;
    FramePlan& plan_;
    Mat3 screen_;
};

} // namespace

void planOwnership(const world::World& world, const world::DynamicState& dynamics, const FrameView& frame,
                   const visibility::VisibleSet& set, FramePlan& plan) {
    OwnershipPlanner(world, dynamics, frame, set, plan).run();
    plan.counts.ownershipTriangles = static_cast<std::uint32_t>(plan.ownershipVertices.size() / 3);
}

} // namespace limen::frame
