#pragma once

#include "geometry/Bounds.h"
#include "geometry/Plane.h"
#include "visibility/Rect.h"
#include "visibility/View.h"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace limen::visibility {

/// The zone of holes. It has no members.
inline constexpr std::uint32_t kNoZone = std::numeric_limits<std::uint32_t>::max();

/// One visit of the eye's rays to a zone: its region on the screen, its entry plane and its portal.
struct Visit {
    std::uint32_t zone = 0;  ///< kNoZone for a hole
    std::uint32_t space = 0; ///< the space entered (EyeSpace.h for the root); kNone for a hole
    std::uint32_t parent = std::numeric_limits<std::uint32_t>::max(); ///< index into visits; max for the root
    std::uint32_t portal =
        std::numeric_limits<std::uint32_t>::max(); ///< the portal it was entered through; max for the root
    Plane entryPlane{Vec3(0.0), 1.0}; ///< eye-relative; beyond = positive. All points are beyond the root's
    std::uint32_t firstVertex = 0, vertexCount = 0; ///< its region: a run of VisibleSet::regionVertices
    std::uint32_t depth = 0;                        ///< 0 for the root
    bool inPlane = false; ///< the eye is in the portal's plane and the region is half of the parent's; true
                          ///< for the root
    bool hole =
        false; ///< the rays pass the portal's polygon and end there: it leads nowhere, its pair is not
               ///< open, or it is closed; no children and no seen spaces
    bool shut = false;     ///< a hole that the opening's filling closes
    bool narrowed = false; ///< of an inexact pair: the other polygon bounds its region, too
    bool split = false; ///< its region is a part of the opening, cut to break a cycle of overlapping siblings
};

/// A space that may be visible in a visit, within `rect`, which may be too large. For culling.
struct SeenSpace {
    std::uint32_t space = 0;
    std::uint32_t visit = 0;
    Rect rect;
};

/// Work done and limits reached.
struct FloodCounts {
    std::uint32_t portalsTested = 0, portalsAdmitted = 0, spaceVisits = 0, revisits = 0;
    std::uint32_t visitsCut = 0;   ///< left out because Limits::maxVisits was reached
    std::uint32_t cyclesSplit = 0; ///< cycles of overlapping siblings that were broken by a cut
    std::uint32_t cyclesLeft = 0;  ///< cycles that no cut breaks: sorted by distance
};

/// The result of one flood; see docs/ray-rule.md. Reuse it: `clear` keeps the capacity.
struct LIMEN_API VisibleSet {
    /// Depth-first, the root first, parents before children, far siblings (with their subtrees) before near
    /// ones. Painting the regions in this order leaves every pixel with its leaf visit.
    std::vector<Visit> visits;
    /// Regions: convex polygons, counter-clockwise, homogeneous (x, y, w) as in View, w >= 0.
    std::vector<Vec3> regionVertices;
    std::vector<SeenSpace> seen; ///< grouped by visit, in the order of visits
    FloodCounts counts;

    [[nodiscard]] std::span<const Vec3> region(const Visit& visit) const {
        return std::span<const Vec3>(regionVertices).subspan(visit.firstVertex, visit.vertexCount);
    }
    void clear();
};

} // namespace limen::visibility
