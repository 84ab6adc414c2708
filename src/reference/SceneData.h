#pragma once

#include "reference/Bodies.h"
#include "reference/Openings.h"
#include "reference/Scene.h"

#include <vector>

namespace limen::reference {

/// The prepared data of a Scene: world and dynamic state by space.
struct SceneData {
    SceneData(const world::World& of, const RuleOptions& with);
    void takeDynamics(const world::DynamicState& dynamics);

    /// Calls act(bodies, lists) for each pair of lists whose bodies a ray can meet in the space.
    template <class Do>
    void forLists(world::SpaceIndex space, Do&& act) const {
        act(fixed, fixedBySpace.at(space));
        if (!movingBySpace.empty())
            act(moving, movingBySpace.at(space));
        if (options.objectsByZone) {
            const world::ZoneIndex zone = world.spaces[space].zone;
            act(fixed, fixedByZone.at(zone));
            act(moving, movingByZone.at(zone));
        }
    }

    const world::World& world;
    const RuleOptions options;
    /// All coordinates inside the scene are relative to this point, so equal blocks anywhere on the map give
    /// equal numbers.
    const Vec3 origin;
    const Openings openings;

    /// The instances of the world, and those of the dynamic state.
    Bodies fixed, moving;
    BodyLists fixedBySpace, movingBySpace;
    BodyLists fixedByZone, movingByZone; ///< with RuleOptions::objectsByZone, objects are in these alone
    std::vector<std::uint8_t> shut;      ///< by portal; empty: all open
    /// By portal: the body of `moving` that fills the shut opening, or kNone; empty: no portal is shut.
    std::vector<world::InstanceIndex> fillings;

private:
    void listFixed();
    void addBySpace(const Bodies& bodies, const world::Instance& instance, std::uint32_t body,
                    world::SpaceIndex space, BodyLists& bySpace) const;
    void addByZone(const Bodies& bodies, const world::Instance& instance, std::uint32_t body,
                   std::span<const world::SpaceIndex> members, BodyLists& byZone) const;
    [[nodiscard]] bool goesByZone(const world::Instance& instance) const;

    std::vector<world::Instance> movingInstances_; ///< copied from the dynamic state
};

struct Scene::Data : SceneData {
    using SceneData::SceneData;
};

} // namespace limen::reference
