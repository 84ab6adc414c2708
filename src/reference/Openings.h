#pragma once

#include "reference/Hierarchy.h"
#include "reference/RayFrame.h"
#include "reference/TriangleSet.h"

#include "core/SmallVec.h"
#include "geometry/Plane.h"
#include "geometry/Tolerances.h"
#include "world/World.h"

#include <limits>
#include <span>
#include <vector>

namespace limen::reference {

class Pyramid;

/// The portal by which a ray leaves a space.
struct Exit {
    world::PortalIndex portal = world::kNone; ///< kNone: by none
    double t = std::numeric_limits<double>::infinity();
    double before = 0.0,
           beyond = 0.0; ///< between these the ray is within kInPlaneTolerance of the portal's plane
    [[nodiscard]] bool found() const { return portal != world::kNone; }
};

/// The inputs of the search for an exit, beside the ray.
struct Leaving {
    world::SpaceIndex space = world::kOutside;
    double after = 0.0;                       ///< parameter where the ray entered the space; 0: at the eye
    world::PortalIndex cameBy = world::kNone; ///< kNone: the ray began in the space
    double nearPlane = 0.0;                   ///< shut portals nearer than this are surfaces that are not met
    std::span<const std::uint8_t> shut;       ///< by portal; empty: none
    /// Portals that the ray has left by with the eye in their plane, or by a gap. They are skipped: a
    /// straight ray crosses a plane once.
    std::span<const world::PortalIndex> notAgain;
};

/// All portals of a world as polygons relative to the scene's origin, with a hierarchy for each space.
class Openings {
public:
    Openings(const world::World& world, const Vec3& origin);

    /// The nearest portal that the ray leaves its space by. At equal parameters the lower index wins.
    [[nodiscard]] Exit nearest(const RayFrame& ray, const BoxRay& boxRay, const Leaving& from) const;
    /// The same among the given portals of the space.
    [[nodiscard]] Exit nearest(std::span<const world::PortalIndex> portals, const RayFrame& ray,
                               const Leaving& from) const;
    /// Appends the portals of a space that a ray of the pyramid may leave it by.
    void gather(world::SpaceIndex space, const Pyramid& pyramid,
                std::vector<world::PortalIndex>& portals) const;
    /// As nearest(), with openings larger by kGapTolerance all around. For rays where nearest() finds none.
    /// `boxRay` must have that margin. `isGap(passes, corners)` is called for each of them, and false leaves it out.
    [[nodiscard]] Exit nearestGrown(const RayFrame& ray, const BoxRay& boxRay, const Leaving& from,
                                    const GapTest& isGap) const;
    /// Calls act(corners) for the portals of a space.
    template <class Do>
    void forCorners(world::SpaceIndex space, Do&& act) const {
        for (const world::PortalIndex i :
             std::span(order_).subspan(spaces_[space].first, spaces_[space].count))
            act(cornersOf(openings_[i]));
    }

    /// The space in which the rays of an eye begin: `root`, or the space behind a portal, open or shut, that the eye
    /// has just passed (docs/ray-rule.md#tolerances).
    [[nodiscard]] world::SpaceIndex spaceOfEye(world::SpaceIndex root, const Vec3& eye) const;

    /// Whether the ray also passes the reciprocal's polygon: always for an exact pair, and an inexact pair is
    /// open only where both polygons are. Requires that the ray passes the portal's own polygon.
    [[nodiscard]] bool passesPair(world::PortalIndex portal, const RayFrame& ray, double after) const;

private:
    struct Opening {
        Plane plane;
        std::uint32_t firstCorner = 0, cornerCount = 0;
        /// The corners with the stitched vertices on its edges; a count of 0: no vertex was stitched in.
        std::uint32_t firstOutline = 0, outlineCount = 0;
        double before = 0.0; ///< metres before the plane up to which an eye is in the plane
    };
    struct SpaceOpenings {
        Hierarchy tree; ///< empty up to kFewPortals
        std::uint32_t first = 0, count = 0;
    };
    /// Calls offer(portal) for portals that the ray may leave its space by, as Hierarchy::walk calls its
    /// leaf.
    template <class Offer>
    void offerAll(const BoxRay& boxRay, const Leaving& from, const double& farthest, Offer&& offer) const;
    /// The ray's speed out through an opening's plane, in metres per unit of its parameter; 0 if it cannot
    /// leave there.
    [[nodiscard]] double speedOut(world::PortalIndex portal, const RayFrame& ray, const Leaving& from) const;
    [[nodiscard]] std::span<const Vec3> cornersOf(const Opening& opening) const {
        return std::span(points_).subspan(opening.firstCorner, opening.cornerCount);
    }
    [[nodiscard]] std::span<const Vec3> outlineOf(const Opening& opening) const {
        return std::span(points_).subspan(opening.firstOutline, opening.outlineCount);
    }
    /// Replaces `exit` if the ray leaves by this portal sooner.
    void offer(world::PortalIndex portal, const RayFrame& ray, const Leaving& from, Exit& exit) const;
    [[nodiscard]] bool isOpenAt(const Opening& opening, const RayFrame& ray) const;
    /// Whether the eye is in an opening's plane and inside its polygon. `way`: 1 for rays out of its space,
    /// -1 into it.
    [[nodiscard]] bool holdsEye(const Opening& opening, const Vec3& eye, double way) const;
    /// Whether the eye is before or behind the opening's polygon, at any distance.
    [[nodiscard]] bool isWithin(const Opening& opening, const Vec3& eye) const;
    [[nodiscard]] bool isPassed(world::PortalIndex portal, const Vec3& eye) const;
    [[nodiscard]] bool isNearest(world::PortalIndex portal, const Vec3& eye) const;
    void addOpening(const world::Portal& portal, const Vec3& origin);

    const world::World& world_;
    std::vector<Vec3> points_;
    std::vector<Opening> openings_;     ///< by portal
    std::vector<SpaceOpenings> spaces_; ///< by space
    std::vector<std::uint32_t> order_;  ///< portals by space, each run in the order of the tree's leaves
};

} // namespace limen::reference
