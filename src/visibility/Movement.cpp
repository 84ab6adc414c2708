#include "visibility/Movement.h"

#include "geometry/ConvexPolygon.h"

namespace limen::visibility {

namespace {

/// A straight way through the spaces of a graph.
class Way {
public:
    Way(const Graph& graph, std::span<const std::uint8_t> closed, const Vec3& from, const Vec3& to)
        : graph_(graph), closed_(closed), from_(from), to_(to) {}

    struct Passed {
        std::uint32_t portal = kNone;
        double at = 2.0; ///< share of the way
    };
    /// The first portal of the space that the way passes, not before `earliest` and not back through `cameBy`.
    [[nodiscard]] Passed next(std::uint32_t space, double earliest, std::uint32_t cameBy) const {
        Passed first;
        const Graph::Space& here = graph_.spaces()[space];
        for (std::uint32_t p = here.firstPortal; p < here.firstPortal + here.portalCount; ++p) {
            if (cameBy != kNone && graph_.portals()[cameBy].reciprocal == p)
                continue;
            const double at = crossing(graph_.portals()[p]);
            if (at >= earliest && at < first.at && isThrough(graph_.portals()[p], at))
                first = {p, at};
        }
        return first;
    }
    /// Whether a way through the portal's polygon enters a space.
    [[nodiscard]] bool isOpen(std::uint32_t index, double at) const {
        const Graph::Portal& portal = graph_.portals()[index];
        if (portal.destination == kNone || (index < closed_.size() && closed_[index] != 0))
            return false;
        return portal.exact || portal.reciprocal == kNone ||
               isThrough(graph_.portals()[portal.reciprocal], at);
    }

private:
    /// The share of the way at which it leaves through the portal's plane; -1 if it does not.
    [[nodiscard]] double crossing(const Graph::Portal& portal) const {
        const double start = portal.plane.signedDistance(from_), end = portal.plane.signedDistance(to_);
        return portal.plane.n != Vec3(0.0) && start >= 0.0 && end < 0.0 ? start / (start - end) : -1.0;
    }
    [[nodiscard]] bool isThrough(const Graph::Portal& portal, double at) const {
        return containsProjection(graph_.polygon(portal), portal.plane.n, from_ + (to_ - from_) * at, 0.0);
    }

    const Graph& graph_;
    std::span<const std::uint8_t> closed_;
    Vec3 from_, to_;
};

} // namespace

Movement spaceAfterMove(const Graph& graph, std::span<const std::uint8_t> closed, std::uint32_t space,
                        const Vec3& from, const Vec3& to) {
    if (space >= graph.spaces().size() || !isFinite(from) || !isFinite(to))
        return {};
    const Way way(graph, closed, from, to);
    Movement movement{space};
    Way::Passed passed{kNone, 0.0};
    // A straight way passes a plane once, so no portal is passed twice.
    for (std::size_t count = 0; count <= graph.portals().size(); ++count) {
        passed = way.next(movement.space, passed.at, passed.portal);
        if (passed.portal == kNone)
            return movement;
        if (!way.isOpen(passed.portal, passed.at)) {
            movement.fraction = passed.at;
            movement.stoppedBy = passed.portal;
            return movement;
        }
        movement.space = graph.portals()[passed.portal].destination;
    }
    return movement;
}

} // namespace limen::visibility
