#include "frame/RootExits.h"

#include "core/Assert.h"
#include "geometry/Tolerances.h"

#include <algorithm>

namespace limen::frame {

namespace {

/// Whether no vertex of a shell is on the far side of a portal's plane, by more than the tolerance that the
/// ownership test has near the eye.
bool isBeforePlane(const world::World& world, const world::Instance& shell, const Plane& plane) {
    const world::Mesh& mesh = world.meshes[shell.mesh];
    const Plane local = plane.relativeTo(world.blocks[shell.block].origin());
    const auto vertices = std::span(world.vertices).subspan(mesh.firstVertex, mesh.vertexCount);
    return std::all_of(vertices.begin(), vertices.end(), [&](const world::MeshVertex& vertex) {
        return local.signedDistance(vertex.corner()) >= -kInPlaneTolerance;
    });
}

} // namespace

void RootExits::prepare(const visibility::VisibleSet& set) {
    exits_.clear();
    for (const visibility::Visit& visit : set.visits)
        if (visit.depth == 1)
            exits_.push_back(&visit);
}

bool RootExits::areBeyond(world::InstanceIndex shell) {
    LIMEN_ASSERT(world_.instances[shell].kind == world::InstanceKind::Shell,
                 "only shells have known vertices");
    return std::all_of(exits_.begin(), exits_.end(),
                       [&](const visibility::Visit* exit) { return isBefore(shell, exit->portal); });
}

bool RootExits::isBefore(world::InstanceIndex shell, world::PortalIndex portal) {
    Known& known = known_[(shell * 2654435761u ^ portal * 40503u) % kKnown];
    if (known.shell != shell || known.portal != portal)
        known = {shell, portal, isBeforePlane(world_, world_.instances[shell], world_.portals[portal].plane)};
    return known.isBefore;
}

} // namespace limen::frame
