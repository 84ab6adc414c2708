#include "frame/OpeningTriangles.h"

#include "geometry/ConvexPolygon.h"
#include "geometry/TwoFloats.h"

#include <algorithm>

namespace limen::frame {

namespace {

/// Metres. An opening nearer to the eye is drawn as a triangle around the whole window. The projected corners
/// of so near a polygon, as floats, are so far off the screen that the rasteriser does not clip it exactly.
constexpr double kNearOpening = 0.05;

/// Edges of a clip set, whose last plane is the entry plane: GL guarantees eight clip distances.
constexpr std::size_t kEdgesPerSet = gpu::kLastClipPlane;

/// Pixels. More than the rasteriser's snapping, the growth of edges and the rounding of floats together.
constexpr double kWellInside = 2.0;

} // namespace

bool OpeningTriangles::isNear(const visibility::Visit& visit) const {
    if (!frame_.rules.nearOpening)
        return false;
    const world::Portal& portal = world_.portals[visit.portal];
    const Vec3& eye = frame_.view.eye;
    const auto polygon = std::span(world_.portalVertices).subspan(portal.firstVertex, portal.vertexCount);
    return std::abs(portal.plane.signedDistance(eye)) < kNearOpening &&
           containsProjection(polygon, portal.plane.n, eye, kNearOpening);
}

gpu::ClipSet OpeningTriangles::openClipSet() {
    gpu::ClipSet open;
    for (gpu::vec4& plane : open.planes)
        plane = {0, 0, 0, 1};
    return open;
}

gpu::vec4 OpeningTriangles::edgePlane(const Vec3& a, const Vec3& b, double growth) const {
    Vec3 edge = glm::cross(a, b);
    edge.z += growth * (std::abs(edge.x) * 2.0 / frame_.width + std::abs(edge.y) * 2.0 / frame_.height);
    const Vec3 n = glm::transpose(screen_) * edge;
    const double length = std::sqrt(glm::dot(n, n));
    return length > 0.0 ? gpu::vec4(Vec3f(n / length), 0.0f) : gpu::vec4(0, 0, 0, 1);
}

void OpeningTriangles::drawWithin(std::uint32_t visit, std::span<const Vec3> region, const Clip& by) {
    for (std::size_t first = 1; first + 1 < region.size(); first += kEdgesPerSet - 2) {
        const std::size_t last = std::min(first + kEdgesPerSet - 2, region.size() - 1);
        gpu::ClipSet clip = openClipSet();
        Clipping clipping{static_cast<std::uint32_t>(plan_.clipSets.size()), 0};
        const auto cut = [&](const Vec3& from, const Vec3& to, double growth) {
            const gpu::vec4 edge = edgePlane(from, to, growth);
            if (!frame_.coverageDecides || mayCut(edge, visit))
                clip.planes[clipping.edges++] = edge;
        };
        cut(region[0], region[first], first == 1 ? by.growth : kGrowth);
        for (std::size_t i = first; i < last; ++i)
            cut(region[i], region[i + 1], by.growth);
        cut(region[last], region[0], last + 1 == region.size() ? by.growth : kGrowth);
        clip.planes[gpu::kLastClipPlane] = by.plane;
        plan_.clipSets.push_back(clip);
        draw(visit, clipping);
    }
}

bool OpeningTriangles::mayCut(const gpu::vec4& edge, std::uint32_t visit) const {
    if (isEdgeOn(set_.visits[visit]))
        return true; // it is drawn around the window
    const double margin = kWellInside * 2.0 * frame_.view.tanHalfY / frame_.height; // radians, at least
    const Vec3 normal(edge.x, edge.y, edge.z);
    const auto polygon = polygonOf(world_, world_.portals[set_.visits[visit].portal]);
    return std::any_of(polygon.begin(), polygon.end(), [&](const Vec3& corner) {
        const Vec3 p = corner - frame_.view.eye;
        return glm::dot(normal, p) < margin * glm::length(p);
    });
}

void OpeningTriangles::draw(std::uint32_t visit, const Clipping& by) {
    if (isEdgeOn(set_.visits[visit]))
        drawEverywhere(visit, by);
    else
        drawPortal(visit, by);
}

void OpeningTriangles::drawRegion(std::uint32_t visit) {
    const auto region = set_.region(set_.visits[visit]);
    const auto first = static_cast<std::uint32_t>(plan_.ownershipVertices.size());
    for (std::size_t i = 1; i + 1 < region.size(); ++i) {
        for (const Vec3& corner : {region[0], region[i], region[i + 1]})
            plan_.ownershipVertices.push_back(
                {Vec3f(corner), 0, visit, 0, first, gpu::kOnScreen, Vec3f(0.0f), 1});
        face(region[0], region[i], region[i + 1]);
    }
}

void OpeningTriangles::drawEverywhere(std::uint32_t visit, const Clipping& by) {
    const auto first = static_cast<std::uint32_t>(plan_.ownershipVertices.size());
    plan_.ownershipVertices.insert(
        plan_.ownershipVertices.end(), 3,
        {Vec3f(0.0f), 0, visit, by.set, first, gpu::kCoverWindow, Vec3f(0.0f), by.edges});
}

/// The portal polygon as a fan around its middle. Every edge of its outline is kept, divided at the same
/// vertices as the edges of the walls.
void OpeningTriangles::drawPortal(std::uint32_t visit, const Clipping& by) {
    const world::Portal& portal = world_.portals[set_.visits[visit].portal];
    const Vec3 origin = world_.blocks[portal.block].origin();
    const auto polygon = std::span(world_.portalVertices).subspan(portal.firstVertex, portal.vertexCount);
    Vec3 middle(0.0);
    for (const Vec3& v : polygon)
        middle += (v - origin) / static_cast<double>(polygon.size());
    const auto first = static_cast<std::uint32_t>(plan_.ownershipVertices.size());
    const std::uint32_t count = portal.vertexCount | (isNear(set_.visits[visit]) ? gpu::kCoverWindow : 0u);
    const auto corner = [&](const Vec3& local) {
        const TwoFloats parts = inTwoFloats(local); // the same split as in the walls' vertices
        plan_.ownershipVertices.push_back(
            {parts.nearest, portal.block, visit, by.set, first, count, parts.rest, by.edges});
    };
    const auto onScreen = [&](const Vec3& local) { return screen_ * (local + origin - frame_.view.eye); };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 from = polygon[i] - origin, to = polygon[(i + 1) % polygon.size()] - origin;
        corner(middle);
        corner(from);
        corner(to);
        face(onScreen(middle), onScreen(from), onScreen(to));
    }
}

// The exact way finds the outline of an opening by the order of its vertices.
void OpeningTriangles::face(const Vec3& a, const Vec3& b, const Vec3& c) {
    if (frame_.coverageDecides && frame_.gate == Gate::Ownership && glm::dot(a, glm::cross(b, c)) < 0.0)
        std::swap(plan_.ownershipVertices.back(),
                  plan_.ownershipVertices[plan_.ownershipVertices.size() - 2]);
}

} // namespace limen::frame
