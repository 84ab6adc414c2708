#pragma once

#include "frame/FrameView.h"
#include "visibility/Viewcone.h"
#include "world/DynamicState.h"

#include <algorithm>
#include <map>

namespace limen::test {

/// The visible instances and whether they are gated, each tested in every visit that lists one of its spaces:
/// the expected result of frame::Selection, without optimization. By number; those of the dynamic state
/// follow the world's.
inline std::map<std::uint32_t, bool> selectOneByOne(const world::World& world,
                                                    const world::DynamicState& dynamics,
                                                    const frame::FrameView& frame,
                                                    const visibility::VisibleSet& set) {
    using visibility::Containment;
    visibility::Viewcones cones;
    cones.prepare(frame.view, set,
                  2.0 * std::max(frame.view.tanHalfX / frame.width, frame.view.tanHalfY / frame.height));
    std::map<std::uint32_t, Containment> best;
    const auto meet = [&](const visibility::SeenSpace& seen, const world::Instance& instance,
                          std::uint32_t number) {
        const auto sphere = cones.sphereOf({instance.bounds.centre - frame.view.eye, instance.bounds.radius});
        const Containment inVisit = cones.classify(seen.visit, sphere);
        if (inVisit != Containment::Outside &&
            visibility::Viewcones::classify(cones.edgesOf(seen.rect), sphere) != Containment::Outside)
            best[number] = std::max(best[number], inVisit);
    };
    for (const visibility::SeenSpace& seen : set.seen) {
        const world::Space& space = world.spaces[seen.space];
        for (std::uint32_t i = space.firstInstance; i < space.firstInstance + space.instanceCount; ++i)
            meet(seen, world.instances[world.spaceInstances[i]], world.spaceInstances[i]);
        for (const world::InstanceIndex i : dynamics.instancesIn(seen.space))
            meet(seen, dynamics.instances[i], static_cast<std::uint32_t>(world.instances.size()) + i);
    }
    std::map<std::uint32_t, bool> drawn;
    for (const auto& [number, seen] : best) {
        const bool moves = number >= world.instances.size();
        const world::Instance& instance =
            moves ? dynamics.instances[number - world.instances.size()] : world.instances[number];
        const auto& members = moves ? dynamics.members : world.members;
        bool oneZone = true;
        for (std::uint32_t m = 0; m < instance.memberCount; ++m) {
            oneZone = oneZone && world.spaces[members[instance.firstMember + m]].zone ==
                                     world.spaces[members[instance.firstMember]].zone;
        }
        drawn[number] = set.visits.size() > 1 && !(seen == Containment::Inside && oneZone);
    }
    return drawn;
}

} // namespace limen::test
