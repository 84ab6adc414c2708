#include "frame/Ownership.h"

#include "frame/OpeningTriangles.h"
#include "geometry/Tolerances.h"
#include "visibility/Graph.h"

#include <algorithm>

namespace limen::frame {

namespace {

class OwnershipPlanner {
public:
    OwnershipPlanner(const world::World& world, const world::DynamicState& dynamics, const FrameView& frame,
                     const visibility::VisibleSet& set, FramePlan& plan)
        : world_(world), dynamics_(dynamics), frame_(frame), set_(set), plan_(plan),
          openings_(world, frame, set, plan) {}

    void run() {
        plan_.clipSets.push_back(OpeningTriangles::openClipSet());
        for (std::uint32_t i = 0; i < set_.visits.size(); ++i) {
            const visibility::Visit& visit = set_.visits[i];
            addVisit(visit);
            if (visit.depth == 0 || !frame_.rules.ownership)
                continue;
            // The region of these is smaller than the part of their outline within their parent's region.
            const bool byRegion = visit.split || OpeningTriangles::isEdgeOn(visit) || visit.narrowed;
            if (frame_.coverageDecides && (OpeningTriangles::isEdgeOn(visit) || openings_.isNear(visit))) {
                openings_.drawRegion(i);
            } else if (byRegion) {
                // As the hole around it, which is painted before and clipped by the parent's region.
                const double growth = visit.narrowed && frame_.rules.growth ? OpeningTriangles::kGrowth : 0.0;
                openings_.drawWithin(i, set_.region(visit), {growth, {0, 0, 0, 1}});
            } else if (set_.visits[visit.parent].depth > 0 && frame_.rules.ancestorClip) {
                const visibility::Visit& parent = set_.visits[visit.parent];
                openings_.drawWithin(
                    i, set_.region(parent),
                    {frame_.rules.growth ? OpeningTriangles::kGrowth : 0.0, planeFor(i, parent.entryPlane)});
            } else {
                openings_.draw(i);
            }
        }
    }

private:
    void addVisit(const visibility::Visit& visit) {
        gpu::Visit out;
        const bool root = visit.depth == 0;
        out.entryPlane = OpeningTriangles::entryPlaneOf(visit);
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

    const world::World& world_;
    const world::DynamicState& dynamics_;
    const FrameView& frame_;
    const visibility::VisibleSet& set_;
    FramePlan& plan_;
    OpeningTriangles openings_;
};

} // namespace

void planOwnership(const world::World& world, const world::DynamicState& dynamics, const FrameView& frame,
                   const visibility::VisibleSet& set, FramePlan& plan) {
    OwnershipPlanner(world, dynamics, frame, set, plan).run();
    plan.counts.ownershipTriangles = static_cast<std::uint32_t>(plan.ownershipVertices.size() / 3);
}

} // namespace limen::frame
