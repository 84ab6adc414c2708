#include "frame/Ownership.h"

#include "geometry/ConvexPolygon.h"
#include "geometry/Tolerances.h"
#include "geometry/TwoFloats.h"
#include "visibility/Graph.h"

#include <algorithm>

namespace limen::frame {

namespace {

/// Metres. An opening nearer to the eye is drawn as a triangle around the whole window. The projected corners
/// of so near a polygon, as floats, are so far off the screen that the rasteriser does not clip it exactly.
constexpr double kNearOpening = 0.05;

/// Pixels by which a parent's edges are moved outwards. The edges are exact, but the parent was drawn with snapped
/// corners: the child must not lose a pixel that the parent owns. With a larger growth the child takes pixels beside
/// a thin jamb that its parent does not own, and surfaces behind the parent's plane show there.
constexpr double kGrowth = kSnapTolerance;

/// Edges of a clip set, whose last plane is the entry plane: GL guarantees eight clip distances.
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
            // The region of these is smaller than the part of their outline within their parent's region.
            const bool byRegion = visit.split || isEdgeOn(visit) || visit.narrowed;
            if (byRegion) {
                drawWithin(i, set_.region(visit), Clip{0.0, {0, 0, 0, 1}});
            } else if (set_.visits[visit.parent].depth > 0 && frame_.rules.ancestorClip) {
                const visibility::Visit& parent = set_.visits[visit.parent];
                drawWithin(i, set_.region(parent),
                           Clip{frame_.rules.growth ? kGrowth : 0.0, planeFor(i, parent.entryPlane)});
            } else {
                draw(i, 0);
            }
        }
    }

private:
    /// How an opening is clipped to a region.
    struct Clip {
        double growth = 0.0;         ///< pixels by which the region's edges are moved outwards
        gpu::vec4 plane{0, 0, 0, 1}; ///< and one more plane
    };

    /// Whether the eye is in the opening's plane or so near it that floats may put it on the wrong side. Then
    /// the flood's region, computed in double, decides alone. Its edges are not exactly the walls', but that
    /// is not visible: such a region is half of all directions, or too thin to hold more than a few pixels.
    [[nodiscard]] static bool isEdgeOn(const visibility::Visit& visit) {
        return visit.inPlane || std::abs(visit.entryPlane.d) < kEyeInPlaneTolerance;
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

    /// gpu::Visit::shutBy of a closed portal.
    [[nodiscard]] std::uint32_t shutBy(std::uint32_t portal) const {
        const world::InstanceIndex filling =
            dynamics_.fillings.empty() ? world::kNone : dynamics_.fillings[portal];
        return filling == world::kNone ? gpu::kShutByNothing : dynamics_.instances[filling].idBase;
    }

    /// The plane that clips the visit's portal; one that clips nothing if the whole polygon is beyond it.
    /// That matters for a polygon seen edge-on, whose depth is too inexact for a test that is not necessary.
    [[nodiscard]] gpu::vec4 planeFor(std::uint32_t visit, const Plane& entry) const {
        const auto polygon = polygonOf(world_, world_.portals[set_.visits[visit].portal]);
        const bool cuts = std::any_of(polygon.begin(), polygon.end(), [&](const Vec3& corner) {
            return entry.signedDistance(corner - frame_.view.eye) < -kInPlaneTolerance;
        });
        return cuts ? gpu::vec4(Vec3f(entry.n), entry.d + kInPlaneTolerance) : gpu::vec4(0, 0, 0, 1);
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

    /// The plane through the eye and one edge of a region, moved outwards by `growth` pixels, eye-relative.
    [[nodiscard]] gpu::vec4 edgePlane(const Vec3& a, const Vec3& b, double growth) const {
        Vec3 edge = glm::cross(a, b);
        edge.z += growth * (std::abs(edge.x) * 2.0 / frame_.width + std::abs(edge.y) * 2.0 / frame_.height);
        const Vec3 n = glm::transpose(screen_) * edge;
        const double length = std::sqrt(glm::dot(n, n));
        return length > 0.0 ? gpu::vec4(Vec3f(n / length), 0.0f) : gpu::vec4(0, 0, 0, 1);
    }

    /// A region with more edges than a clip set has is divided into fans around its first vertex, one draw
    /// each. The inner edges of the fans are always moved outwards, so that the fans overlap and leave no
    /// gap.
    void drawWithin(std::uint32_t visit, std::span<const Vec3> region, const Clip& by) {
        for (std::size_t first = 1; first + 1 < region.size(); first += kEdgesPerSet - 2) {
            const std::size_t last = std::min(first + kEdgesPerSet - 2, region.size() - 1);
            gpu::ClipSet clip = openClipSet();
            std::size_t slot = 0;
            clip.planes[slot++] = edgePlane(region[0], region[first], first == 1 ? by.growth : kGrowth);
            for (std::size_t i = first; i < last; ++i)
                clip.planes[slot++] = edgePlane(region[i], region[i + 1], by.growth);
            clip.planes[slot++] =
                edgePlane(region[last], region[0], last + 1 == region.size() ? by.growth : kGrowth);
            clip.planes[kEdgesPerSet] = by.plane;
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

    /// The portal polygon as a fan around its middle. Every edge of its outline is kept, divided at the same
    /// vertices as the edges of the walls.
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
            const TwoFloats parts = inTwoFloats(local); // the same split as in the walls' vertices
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
