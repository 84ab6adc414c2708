#pragma once

#include "core/Error.h"
#include "geometry/Bounds.h"
#include "geometry/Plane.h"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace limen::visibility {

inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// A space as the caller describes it: a run of portals, and its zone. The spaces of one zone must be closed, pairwise
/// disjoint, and connected by exact pairs of portals: inside a zone, depth alone decides which surface is in front.
/// No space of a zone may have a wall or a portal right behind an opening that leads out of the zone from another space.
/// checkZones (ZoneCheck.h) finds such faults. A space with a zone of its own has no conditions.
struct SpaceDesc {
    std::uint32_t firstPortal = 0, portalCount = 0;
    std::uint32_t zone = 0;
};

/// An opening that leads out of `space`.
struct PortalDesc {
    std::uint32_t space = 0;
    std::uint32_t destination = kNone; ///< kNone: leads nowhere
    std::uint32_t reciprocal = kNone; ///< the portal that leads back through the same opening; kNone: one-way
    std::uint32_t firstVertex = 0, vertexCount = 0; ///< convex, counter-clockwise seen from inside `space`
    bool exact = true; ///< false: the reciprocal's polygon differs, and the opening is their intersection
    /// The polygon with the vertices that walls have on, or nearly on, its edges (visibility/Outline.h);
    /// count 0: none.
    std::uint32_t firstOutline = 0, outlineCount = 0;
};

/// Spaces joined by portals, ready to be flooded: the caller's arrays checked and copied, with planes and,
/// for spaces with many portals, a tree of bounds. Immutable; may be shared by threads.
class LIMEN_API Graph {
public:
    /// Checks every index and copies. `vertices` are metres in one frame of the caller's choice. A portal
    /// without area, or with fewer than three vertices, is kept but never admitted. Errors: BadArgument for
    /// an index out of range, a portal outside the run of its space, a vertex that is not finite.
    [[nodiscard]] static Result<Graph> build(std::span<const SpaceDesc> spaces,
                                             std::span<const PortalDesc> portals,
                                             std::span<const Vec3> vertices);

    /// A node of a space's tree of portal bounds; a leaf has one portal. The second child follows the first.
    struct BoundsNode {
        Aabb box;
        std::uint32_t child = kNone;  ///< kNone: a leaf
        std::uint32_t portal = kNone; ///< of a leaf
    };
    struct Space {
        std::uint32_t firstPortal = 0, portalCount = 0, zone = 0;
        std::uint32_t root = kNone; ///< into `boundsNodes`; kNone: few portals, no tree
    };
    struct Portal {
        Plane plane; ///< `space` is on the positive side; n = 0 for a polygon without area
        std::uint32_t space = 0, destination = kNone, reciprocal = kNone;
        std::uint32_t firstVertex = 0, vertexCount = 0;
        bool exact = true;
        bool withinZone = false; ///< it has an area and leads to another space of the same zone
        std::uint32_t firstOutline = 0, outlineCount = 0; ///< count 0: the polygon is flat and has no outline
        double inPlane = 0.0; ///< metres before its plane up to which an eye is in it
    };

    [[nodiscard]] std::span<const Space> spaces() const { return spaces_; }
    [[nodiscard]] std::span<const Portal> portals() const { return portals_; }
    [[nodiscard]] std::span<const BoundsNode> boundsNodes() const { return nodes_; }
    [[nodiscard]] std::span<const Vec3> polygon(const Portal& portal) const {
        return std::span<const Vec3>(vertices_).subspan(portal.firstVertex, portal.vertexCount);
    }
    [[nodiscard]] std::span<const Vec3> outline(const Portal& portal) const {
        return std::span<const Vec3>(outlines_).subspan(portal.firstOutline, portal.outlineCount);
    }

private:
    void addPortal(const PortalDesc& desc, std::span<const SpaceDesc> spaces, std::span<const Vec3> vertices);

    std::vector<Vec3> outlines_;
    std::vector<Space> spaces_;
    std::vector<Portal> portals_;
    std::vector<Vec3> vertices_;
    std::vector<BoundsNode> nodes_;
};

} // namespace limen::visibility
