#include "visibility/EyePaths.h"

#include "visibility/Admission.h"
#include "visibility/EyeSpace.h"
#include "visibility/Region.h"

namespace limen::visibility {

namespace {

/// The part of a region whose rays point out of the portal's space (`way` 1) or into it (-1), into `out`.
void cutRegion(const FloodInput& input, std::span<const Vec3> region, std::uint32_t portal, double way,
               std::vector<Vec3>& out) {
    clipByEyePlane(region, input.eyeFromScreenTransposed * (input.graph.portals()[portal].plane.n * -way),
                   out);
    tidyRegion(out);
}

} // namespace

/// Whether rays leave the path's space by the portal at the eye, and not back the way they came.
bool EyePaths::isOpen(const FloodInput& input, std::size_t path, std::uint32_t portal) const {
    if (!input.closed.empty() && input.closed[portal] != 0)
        return false;
    const std::uint32_t cameBy = paths_[path].cameBy;
    if (cameBy != kNone && input.graph.portals()[cameBy].reciprocal == portal)
        return false;
    for (std::size_t i = path; paths_[i].parent != i; i = paths_[i].parent)
        if (paths_[i].cameBy == portal)
            return false;
    return isLeftAtEye(input.graph, portal, input.view.eye);
}

/// The rays of a path that leave by the target, and those that come into other spaces of the zone. Other openings out of the
/// zone cut nothing from the target's rays: SiblingOrder puts them in order.
void EyePaths::leave(const FloodInput& input, std::size_t path, std::uint32_t target) {
    const Graph::Space& space = input.graph.spaces()[paths_[path].space];
    rest_ = within_ = paths_[path].region; // within: no opening inside the zone has taken them
    for (std::uint32_t p = space.firstPortal; p < space.firstPortal + space.portalCount; ++p) {
        const bool isInner = input.graph.portals()[p].withinZone;
        if (p == target) {
            cutRegion(input, within_, p, 1.0, found_[foundCount_]);
            foundCount_ += found_[foundCount_].empty() ? 0 : 1;
        }
        if (!isOpen(input, path, p))
            continue;
        if (isInner && pathCount_ < kMostPaths) {
            Path& next = paths_[pathCount_];
            cutRegion(input, rest_, p, 1.0, next.region);
            next.space = input.graph.portals()[p].destination;
            next.cameBy = p;
            next.parent = path;
            pathCount_ += next.region.empty() ? 0 : 1;
        }
        cutRegion(input, rest_, p, -1.0, swap_);
        rest_.swap(swap_);
        if (isInner) {
            cutRegion(input, within_, p, -1.0, swap_);
            within_.swap(swap_);
        }
    }
}

void EyePaths::find(const FloodInput& input, const Visit& visit, std::span<const Vec3> region,
                    std::uint32_t portal) {
    foundCount_ = 0;
    paths_[0].space = visit.space;
    paths_[0].cameBy = visit.portal;
    paths_[0].parent = 0;
    paths_[0].region.assign(region.begin(), region.end());
    pathCount_ = 1;
    for (std::size_t i = 0; i < pathCount_; ++i)
        leave(input, i, portal);
}

} // namespace limen::visibility
