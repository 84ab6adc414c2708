#include "frame/Ownership.h"

#include "geometry/ConvexPolygon.h"
#include "visibility/Region.h"

#include <algorithm>

namespace limen::frame {

namespace {

/// Polygons nearer to the eye than this, in metres, are drawn as the flood's region: in float, the edges of a polygon that
/// close lie so far off the screen that their clipped ends are no longer exact. No further, for the region is not drawn
/// from the walls' own corners and may leave a pixel between itself and the wall to nobody.
constexpr double kNearOpening = 0.001;

/// What is kept before a parent's entry plane, in metres: openings that touch the plane must not be nibbled
/// at by float rounding. Equal to the fragment test's own tolerance (shaders/include/gate.glsl).
constexpr double kEntryTolerance = 0.001;

/// Pixels by which a parent's edges are moved outwards. They are exact, while the parent itself was drawn with corners
/// snapped to 1/256 of a pixel: a pixel it owns must not be lost to its child. No more than that, or the child takes
/// pixels beside a thin jamb whose parent does not own them, and with them what lies behind the parent's plane there.
constexpr double kGrowth = 1.0 / 128.0;

/// Edges that fit a clip set beside the entry plane: GL guarantees eight clip distances.
constexpr std::size_t kEdgesPerSet = 7;

class OwnershipPlanner {
public:
    OwnershipPlanner(const world::World& world, const FrameView& frame, const visibility::VisibleSet& set,
                     FramePlan& plan)
        : world_(world), frame_(frame), set_(set), plan_(plan), screen_(frame.view.screenFromEye()) {}

    void run() {
        plan_.clipSets.push_back(openClipSet());
        for (std::uint32_t i = 0; i < set_.visits.size(); ++i) {
            const visibility::Visit& visit = set_.visits[i];
            addVisit(visit);
            if (visit.depth == 0 || !frame_.rules.ownership) {
                continue;
            }
            const world::Portal& portal = world_.portals[visit.portal];
            if (visit.split || visit.inPlane || isNear(portal)) {
                drawRegion(i);
            } else {
                drawPortal(i);
            }
        }
    }

private:
    void addVisit(const visibility::Visit& visit) {
        gpu::Visit out;
        const bool root = visit.depth == 0;
        out.entryPlane =
            root ? gpu::vec4(0, 0, 0, 1) : gpu::vec4(Vec3f(visit.entryPlane.n), visit.entryPlane.d);
        out.zone = visit.zone;
        out.parent = root ? gpu::kNoVisit : visit.parent;
        plan_.visits.push_back(out);
    }

    [[nodiscard]] bool isNear(const world::Portal& portal) const {
        if (!frame_.rules.nearOpening) {
            return false;
        }
        const Vec3& eye = frame_.view.eye;
        const auto polygon = std::span(world_.portalVertices).subspan(portal.firstVertex, portal.vertexCount);
        return std::abs(portal.plane.signedDistance(eye)) < kNearOpening &&
               containsProjection(polygon, portal.plane.n, eye, kNearOpening);
    }

    [[nodiscard]] static gpu::ClipSet openClipSet() {
        gpu::ClipSet open;
        for (gpu::vec4& plane : open.planes) {
            plane = {0, 0, 0, 1};
        }
        return open;
    }

    /// The plane through the eye and one edge of a region, moved outwards by kGrowth, eye-relative.
    [[nodiscard]] gpu::vec4 grownEdge(const Vec3& a, const Vec3& b) const {
        Vec3 edge = glm::cross(a, b);
        if (frame_.rules.growth) {
            edge.z +=
                kGrowth * (std::abs(edge.x) * 2.0 / frame_.width + std::abs(edge.y) * 2.0 / frame_.height);
        }
        const Vec3 n = glm::transpose(screen_) * edge;
        const double length = std::sqrt(glm::dot(n, n));
        return length > 0.0 ? gpu::vec4(Vec3f(n / length), 0.0f) : gpu::vec4(0, 0, 0, 1);
    }

    void drawRegion(std::uint32_t visit) {
        const auto region = set_.region(set_.visits[visit]);
        for (std::size_t i = 1; i + 1 < region.size(); ++i) {
            for (const std::size_t corner : {std::size_t{0}, i, i + 1}) {
                plan_.ownershipVertices.push_back({Vec3f(region[corner]), gpu::kNoVisit, visit, 0, 0, 0});
            }
        }
    }

    /// The part of the parent's region that the way back's polygon leaves open, into limit_.
    void clipByReciprocal(const visibility::Visit& parent, const world::Portal& reciprocal) {
        std::vector<Vec3> edges;
        for (const Vec3& corner : cornersOf(world_, reciprocal)) {
            edges.push_back(screen_ * (corner - frame_.view.eye));
        }
        std::reverse(edges.begin(), edges.end()); // counter-clockwise from the other side
        visibility::clipByRegion(set_.region(parent), edges, limit_, swap_);
    }

    void drawPortal(std::uint32_t index) {
        const visibility::Visit& visit = set_.visits[index];
        const visibility::Visit& parent = set_.visits[visit.parent];
        const world::Portal& portal = world_.portals[visit.portal];
        if (visit.narrowed) {
            clipByReciprocal(parent, world_.portals[portal.reciprocal]);
            drawPortalWithin(index, limit_, parent.entryPlane);
        } else if (parent.depth == 0 || !frame_.rules.ancestorClip) {
            drawPolygon(index, 0);
        } else {
            drawPortalWithin(index, set_.region(parent), parent.entryPlane);
        }
    }

    /// Whether the entry plane cuts the portal at all. Where it does not it must not be asked about: of a polygon seen
    /// edge-on the pixel's centre, by the rasteriser's snapping, may stand for a point far beyond the polygon's edge.
    [[nodiscard]] bool reachesBefore(const Plane& entry, std::uint32_t visit) const {
        const auto polygon = polygonOf(world_, world_.portals[set_.visits[visit].portal]);
        return std::any_of(polygon.begin(), polygon.end(), [&](const Vec3& corner) {
            return entry.signedDistance(corner - frame_.view.eye) < -kEntryTolerance;
        });
    }

    void drawPortalWithin(std::uint32_t visit, std::span<const Vec3> region, const Plane& entry) {
        const gpu::vec4 entryPlane = reachesBefore(entry, visit)
                                         ? gpu::vec4(Vec3f(entry.n), entry.d + kEntryTolerance)
                                         : gpu::vec4(0, 0, 0, 1);
        // A region with more edges than fit is cut into fans around its first vertex, each drawn for itself;
        // the fans' inner edges grow too, so that they overlap rather than gape.
        for (std::size_t first = 1; first + 1 < region.size(); first += kEdgesPerSet - 2) {
            const std::size_t last = std::min(first + kEdgesPerSet - 2, region.size() - 1);
            gpu::ClipSet clip = openClipSet();
            std::size_t slot = 0;
            clip.planes[slot++] = grownEdge(region[0], region[first]);
            for (std::size_t i = first; i < last; ++i) {
                clip.planes[slot++] = grownEdge(region[i], region[i + 1]);
            }
            clip.planes[slot++] = grownEdge(region[last], region[0]);
            clip.planes[kEdgesPerSet] = entryPlane;
            plan_.clipSets.push_back(clip);
            drawPolygon(visit, static_cast<std::uint32_t>(plan_.clipSets.size() - 1));
        }
    }

    /// The portal polygon as a fan around its middle: every edge of its outline stays as it is, divided
    /// exactly where the walls' are.
    void drawPolygon(std::uint32_t visit, std::uint32_t clipSet) {
        const world::Portal& portal = world_.portals[set_.visits[visit].portal];
        const Vec3 origin = world_.blocks[portal.block].origin();
        const auto polygon = std::span(world_.portalVertices).subspan(portal.firstVertex, portal.vertexCount);
        Vec3 middle(0.0);
        for (const Vec3& v : polygon) {
            middle += (v - origin) / static_cast<double>(polygon.size());
        }
        const auto corner = [&](const Vec3& local) {
            plan_.ownershipVertices.push_back({Vec3f(local), portal.block, visit, clipSet, 0, 0});
        };
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            corner(middle);
            corner(polygon[i] - origin);
            corner(polygon[(i + 1) % polygon.size()] - origin);
        }
    }

    const world::World& world_;
    const FrameView& frame_;
    const visibility::VisibleSet& set_;
    FramePlan& plan_;
    Mat3 screen_;
    std::vector<Vec3> limit_, swap_;
};

} // namespace

void planOwnership(const world::World& world, const FrameView& frame, const visibility::VisibleSet& set,
                   FramePlan& plan) {
    OwnershipPlanner(world, frame, set, plan).run();
    plan.counts.ownershipTriangles = static_cast<std::uint32_t>(plan.ownershipVertices.size() / 3);
}

} // namespace limen::frame
