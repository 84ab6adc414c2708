#pragma once

#include "reference/TracedWorld.h"
#include "world/DynamicState.h"

namespace limen::test {

/// Makes a dynamic state by hand. Its instances use the meshes of a world's static instances, so a test puts
/// the models that it needs into a closed room far away.
class DynamicStateMaker {
public:
    explicit DynamicStateMaker(const world::World& world) : world_(world), nextId_(world.idEnd) {}

    /// An instance of the mesh of the static whose idBase shows as `like`, at `position` (local to its
    /// block), upright. Returns its idBase.
    std::uint32_t add(world::InstanceIndex like, const Vec3& position, std::vector<world::SpaceIndex> members,
                      world::InstanceKind kind = world::InstanceKind::Dynamic) {
        world::Instance instance = world_.instances[like];
        instance.kind = kind;
        instance.linear = glm::mat3(1.0f);
        instance.origin = Vec3f(position);
        instance.bounds = {world_.blocks[instance.block].origin() + position, 100.0};
        instance.placedIn = members.front();
        instance.setMembers(static_cast<std::uint32_t>(dynamics_.members.size()), members.size());
        instance.idBase = nextId_;
        nextId_ += world_.meshes[instance.mesh].polygonCount;
        dynamics_.members.insert(dynamics_.members.end(), members.begin(), members.end());
        dynamics_.instances.push_back(instance);
        return instance.idBase;
    }
    /// Shuts both portals of a pair; the last instance added fills them.
    void shut(world::PortalIndex portal, bool filled = true) {
        dynamics_.closed.resize(world_.portals.size(), 0);
        dynamics_.fillings.resize(world_.portals.size(), world::kNone);
        for (const world::PortalIndex p : {portal, world_.portals[portal].reciprocal}) {
            dynamics_.closed[p] = 1;
            dynamics_.fillings[p] =
                filled ? static_cast<world::InstanceIndex>(dynamics_.instances.size() - 1) : world::kNone;
        }
    }
    [[nodiscard]] world::DynamicState build() {
        world::listBySpace(world_.spaces.size(), dynamics_);
        return dynamics_;
    }

private:
    const world::World& world_;
    world::DynamicState dynamics_;
    std::uint32_t nextId_;
};

/// A square panel around the origin in the plane x = 0, `half` metres to each side.
[[nodiscard]] inline Wall panel(double half, const std::string& surface, bool twoSided = true) {
    std::vector<Vec3> points = rectangle({0, -half, -half}, {0, half, half});
    std::reverse(points.begin(), points.end()); // its front looks west
    return {points, surface, twoSided};
}

/// A wall and its back as a polygon of its own: the second polygon of the model looks the other way.
[[nodiscard]] inline Walls bothWays(const Wall& wall) {
    return {wall, insideOut({wall}).front()};
}

/// The static instance made from a model. Requires that there is one.
[[nodiscard]] inline world::InstanceIndex staticOf(const world::World& world, std::uint32_t model) {
    for (world::InstanceIndex i = 0; i < world.instances.size(); ++i)
        if (world.instances[i].record == model && world.instances[i].kind == world::InstanceKind::Static)
            return i;
    ADD_FAILURE() << "no static of this model";
    return 0;
}

} // namespace limen::test
