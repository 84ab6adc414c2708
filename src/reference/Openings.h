#pragma once

#include "reference/Hierarchy.h"
#include "reference/RayFrame.h"

#include "core/SmallVec.h"
#include "geometry/Plane.h"
#include "world/World.h"

#include <limits>
#include <span>
#include <vector>

namespace limen::reference {

class Pyramid;

/// Metres: an eye this near to a portal's plane is in it, and a surface this near is met from both of its sides
/// (docs/ray-rule.md). Also the widest gap that is a rounding of data: corners nearer than this are one corner to the
/// loader (src/world/README.md#invariants), so what is narrower was meant to be closed.
inline constexpr double kTolerance = 0.0002;
/// Metres before an opening's plane up to which an eye is in it, beside what its corners are off it.
inline constexpr double kBefore = 0.00001;

/// The portal by which a ray leaves a space.
struct Exit {
    world::PortalIndex portal = world::kNone; ///< kNone: by none
    double t = std::numeric_limits<double>::infinity();
    double before = 0.0, beyond = 0.0; ///< between them the ray is within kTolerance of the portal's plane
    [[nodiscard]] bool found() const { return portal != world::kNone; }
};

/// What the search for an exit depends on beside the ray.
struct Leaving {
    world::SpaceIndex space = world::kOutside;
    double after = 0.0;                       ///< where the ray entered the space; 0: at the eye
    world::PortalIndex cameBy = world::kNone; ///< kNone: it began there
    double nearPlane = 0.0;                   ///< shut portals nearer than this are surfaces that are not met
    std::span<const std::uint8_t> shut;       ///< by portal; empty: none
    /// Portals left through with the eye in their plane, or by a gap: not a second time, for a straight ray crosses a
    /// plane once.
    std::span<const world::PortalIndex> notAgain;
};

/// All portals of a world as polygons relative to the scene's origin, with a hierarchy for each space.
class Openings {
public:
    Openings(const world::World& world, const Vec3& origin);

    /// The nearest portal that the ray leaves its space through. Of two at the same parameter the one with the lower
    /// index.
    [[nodiscard]] Exit nearest(const RayFrame& ray, const BoxRay& boxRay, const Leaving& from) const;
    /// The same, of these portals of the space alone.
    [[nodiscard]] Exit nearest(std::span<const world::PortalIndex> portals, const RayFrame& ray,
                               const Leaving& from) const;
    /// Appends those of a space's portals that a ray of the pyramid may leave it through.
    void gather(world::SpaceIndex space, const Pyramid& pyramid,
                std::vector<world::PortalIndex>& portals) const;
    /// The same with openings larger by kTolerance all around, where nearest() finds none. `boxRay` must have that
    /// margin.
    [[nodiscard]] Exit nearestGrown(const RayFrame& ray, const BoxRay& boxRay, const Leaving& from) const;

    /// Whether the opening is open for the ray in the data: always for an exact pair; an inexact pair is open where both
    /// polygons are. Requires that the ray passes the portal's own polygon.
    [[nodiscard]] bool passesPair(world::PortalIndex portal, const RayFrame& ray, double after) const;

private:
    struct Opening {
        Plane plane;
        std::uint32_t firstCorner = 0, cornerCount = 0;
        /// With vertices that other polygons have on its edges; a count of 0: none are.
        std::uint32_t firstOutline = 0, outlineCount = 0;
        double before = 0.0; ///< metres before its plane up to which an eye is in it
    };
    struct SpaceOpenings {
        Hierarchy tree; ///< only of more than kFewPortals
        std::uint32_t first = 0, count = 0;
    };
    /// Calls offer(portal) for those that the ray may leave its space through, as Hierarchy::walk calls its leaf.
    template <class Offer>
    void offerAll(const BoxRay& boxRay, const Leaving& from, const double& farthest, Offer&& offer) const;
    /// Metres a unit of the ray's parameter towards an opening's plane, if it can be left through with this ray; else 0.
    [[nodiscard]] double speedOut(world::PortalIndex portal, const RayFrame& ray, const Leaving& from) const;
    [[nodiscard]] std::span<const Vec3> cornersOf(const Opening& opening) const {
        return std::span(points_).subspan(opening.firstCorner, opening.cornerCount);
    }
    [[nodiscard]] std::span<const Vec3> outlineOf(const Opening& opening) const {
        return std::span(points_).subspan(opening.firstOutline, opening.outlineCount);
    }
    /// One portal after the other lowers `exit` to the nearest.
    void offer(world::PortalIndex portal, const RayFrame& ray, const Leaving& from, Exit& exit) const;
    [[nodiscard]] bool isOpenAt(const Opening& opening, const RayFrame& ray) const;
    /// `way`: 1 for rays out of its space, -1 for those into it.
    [[nodiscard]] bool holdsEye(const Opening& opening, const Vec3& eye, double way) const;
    void addOpening(const world::Portal& portal, const Vec3& origin);

    const world::World& world_;
    std::vector<Vec3> points_;
    std::vector<Opening> openings_;     ///< by portal
    std::vector<SpaceOpenings> spaces_; ///< by space
    std::vector<std::uint32_t> order_;  ///< portals in the order of the leaves of their space's tree
};

} // namespace limen::reference
