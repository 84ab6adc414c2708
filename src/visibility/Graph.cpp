#include "visibility/Graph.h"

#include "geometry/Tolerances.h"

#include <algorithm>
#include <numeric>
#include <string>

namespace limen::visibility {

namespace {

/// Spaces with more portals than this get a tree of bounds. For fewer, testing each portal costs less than
/// the tree.
constexpr std::uint32_t kPortalsWithoutTree = 12;

/// Metres. A polygon whose vertices are within this distance of its plane is convex from every eye.
constexpr double kFlat = 1e-9;

Result<void> checkPortal(const PortalDesc& portal, std::size_t index, std::span<const SpaceDesc> spaces,
                         std::size_t portalCount, std::span<const Vec3> vertices) {
    const std::string where = "portal " + std::to_string(index);
    if (portal.space >= spaces.size() || (portal.destination != kNone && portal.destination >= spaces.size()))
        return fail(ErrorCode::BadArgument, where, "names a space that does not exist");
    const SpaceDesc& space = spaces[portal.space];
    if (index < space.firstPortal || index - space.firstPortal >= space.portalCount)
        return fail(ErrorCode::BadArgument, where, "is not in the run of portals of its space");
    if (portal.reciprocal != kNone && portal.reciprocal >= portalCount)
        return fail(ErrorCode::BadArgument, where, "names a reciprocal portal that does not exist");
    if (portal.firstVertex > vertices.size() || portal.vertexCount > vertices.size() - portal.firstVertex)
        return fail(ErrorCode::BadArgument, where, "has vertices outside the array");
    if (portal.firstOutline > vertices.size() || portal.outlineCount > vertices.size() - portal.firstOutline)
        return fail(ErrorCode::BadArgument, where, "has an outline outside the array");
    const auto finite = [](const Vec3& v) { return isFinite(v); };
    const auto polygon = vertices.subspan(portal.firstVertex, portal.vertexCount);
    const auto outline = vertices.subspan(portal.firstOutline, portal.outlineCount);
    if (!std::all_of(polygon.begin(), polygon.end(), finite) ||
        !std::all_of(outline.begin(), outline.end(), finite))
        return fail(ErrorCode::BadArgument, where, "has a vertex that is not finite");
    return {};
}

/// Builds the tree of one space by halving the portals along the longest side of their box.
class BoundsTree {
public:
    BoundsTree(std::vector<Graph::BoundsNode>& nodes, std::span<const Aabb> boxes)
        : nodes_(nodes), boxes_(boxes) {}

    std::uint32_t build(std::span<std::uint32_t> portals) {
        const auto root = static_cast<std::uint32_t>(nodes_.size());
        nodes_.emplace_back();
        fill(root, portals);
        return root;
    }

private:
    void fill(std::uint32_t node, std::span<std::uint32_t> portals) {
        Aabb box;
        for (const std::uint32_t p : portals)
            box.include(boxes_[p]);
        nodes_[node].box = box;
        if (portals.size() == 1) {
            nodes_[node].portal = portals[0];
            return;
        }
        const Vec3 size = box.max - box.min;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
        std::sort(portals.begin(), portals.end(), [&](std::uint32_t a, std::uint32_t b) {
            const double ca = boxes_[a].centre()[axis];
            const double cb = boxes_[b].centre()[axis];
            return ca != cb ? ca < cb : a < b;
        });
        const auto child = static_cast<std::uint32_t>(nodes_.size());
        nodes_.resize(nodes_.size() + 2);
        nodes_[node].child = child;
        fill(child, portals.first(portals.size() / 2));
        fill(child + 1, portals.subspan(portals.size() / 2));
    }

    std::vector<Graph::BoundsNode>& nodes_;
    std::span<const Aabb> boxes_;
};

/// The largest distance of a corner from the plane.
double unevenness(const Plane& plane, std::span<const Vec3> polygon, std::span<const Vec3> outline) {
    double most = 0.0;
    for (const std::span<const Vec3> corners : {polygon, outline})
        for (const Vec3& corner : corners)
            most = std::max(most, std::abs(plane.signedDistance(corner)));
    return most;
}

} // namespace

void Graph::addPortal(const PortalDesc& desc, std::span<const SpaceDesc> spaces,
                      std::span<const Vec3> vertices) {
    const auto polygon = vertices.subspan(desc.firstVertex, desc.vertexCount);
    const Plane plane = planeOf(polygon);
    const bool isFlat = std::all_of(polygon.begin(), polygon.end(), [&](const Vec3& v) {
        return std::abs(plane.signedDistance(v)) <= kFlat;
    });
    const auto outline = desc.outlineCount > 0 ? vertices.subspan(desc.firstOutline, desc.outlineCount)
                                               : polygon.first(isFlat ? 0 : polygon.size());
    const bool isWithinZone = plane.n != Vec3(0.0) && desc.destination != kNone &&
                              desc.destination != desc.space &&
                              spaces[desc.destination].zone == spaces[desc.space].zone;
    portals_.push_back(
        {plane, desc.space, desc.destination, desc.reciprocal, desc.firstVertex, desc.vertexCount, desc.exact,
         isWithinZone, static_cast<std::uint32_t>(outlines_.size()),
         static_cast<std::uint32_t>(outline.size()),
         std::min(kInPlaneTolerance, kEyeInPlaneTolerance + unevenness(plane, polygon, outline))});
    outlines_.insert(outlines_.end(), outline.begin(), outline.end());
}

Result<Graph> Graph::build(std::span<const SpaceDesc> spaces, std::span<const PortalDesc> portals,
                           std::span<const Vec3> vertices) {
    Graph graph;
    graph.vertices_.assign(vertices.begin(), vertices.end());
    std::vector<Aabb> boxes(portals.size());
    for (std::size_t i = 0; i < portals.size(); ++i) {
        const PortalDesc& p = portals[i];
        if (auto checked = checkPortal(p, i, spaces, portals.size(), vertices); !checked)
            return Failure(checked.error());
        graph.addPortal(p, spaces, vertices);
        for (const Vec3& v : graph.polygon(graph.portals_.back()))
            boxes[i].include(v);
        for (const Vec3& v : graph.outline(graph.portals_.back()))
            boxes[i].include(v);
    }
    std::vector<std::uint32_t> order;
    for (std::size_t i = 0; i < spaces.size(); ++i) {
        const SpaceDesc& s = spaces[i];
        if (s.firstPortal > portals.size() || s.portalCount > portals.size() - s.firstPortal)
            return fail(ErrorCode::BadArgument, "space " + std::to_string(i),
                        "has portals outside the array");
        Space space{s.firstPortal, s.portalCount, s.zone, kNone};
        if (s.portalCount > kPortalsWithoutTree) {
            order.resize(s.portalCount);
            std::iota(order.begin(), order.end(), s.firstPortal);
            // A portal without vertices has no box and is never admitted.
            std::erase_if(order, [&](std::uint32_t p) { return boxes[p].empty(); });
            if (!order.empty())
                space.root = BoundsTree(graph.nodes_, boxes).build(order);
        }
        graph.spaces_.push_back(space);
    }
    return graph;
}

} // namespace limen::visibility
