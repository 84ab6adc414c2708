#pragma once

#include "reference/Bodies.h"
#include "reference/Openings.h"
#include "reference/Scene.h"

#include <vector>

namespace limen::reference {

/// What a Scene has made of its world and moment.
struct SceneData {
    SceneData(const world::World& of, const RuleOptions& with);
    void takeDynamics(const world::DynamicState& dynamics);

    /// Calls act(bodies, place) for all that a ray can meet in the space.
    template <class Do>
    void forPlaces(world::SpaceIndex space, Do&& act) const {
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
    /// All coordinates inside the scene are relative to it: the same blocks elsewhere on the map give the same numbers.
    const Vec3 origin;
    const Openings openings;

    /// What the world holds, and what the moment holds.
    Bodies fixed, moving;
    BodyLists fixedBySpace, movingBySpace;
    BodyLists fixedByZone, movingByZone; ///< by RuleOptions::objectsByZone: objects are in these alone
    std::vector<std::uint8_t> shut;      ///< by portal; empty: all open
    /// By portal: the one of `moving` that fills the shut opening, or kNone; empty: none.
    std::vector<world::InstanceIndex> fillings;

private:
    void listFixed();
    void addBySpace(const Bodies& bodies, const world::Instance& instance, std::uint32_t body,
                    world::SpaceIndex space, BodyLists& bySpace) const;
    void addByZone(const Bodies& bodies, const world::Instance& instance, std::uint32_t body,
                   std::span<const world::SpaceIndex> members, BodyLists& byZone) const;
    [[nodiscard]] bool goesByZone(const world::Instance& instance) const;

    std::vector<world::Instance> movingInstances_; ///< of the moment
};

struct Scene::Data : SceneData {
    using SceneData::SceneData;
};

} // namespace limen::reference
