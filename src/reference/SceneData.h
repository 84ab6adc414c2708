#pragma once

#include "reference/Openings.h"
#include "reference/Scene.h"
#include "reference/TriangleSet.h"

#include <vector>

namespace limen::reference {

/// What can be met in one space, or by RuleOptions::objectsByZone in one zone.
struct Bodies {
    TriangleSet solid;   ///< opaque and cut-out
    TriangleSet blended; ///< translucent
};

/// Bodies by space (or zone), of which those that hold something are remembered for clearing.
class BodyTable {
public:
    void resize(std::size_t count) { bodies_.resize(count); }
    void add(const world::World& world, std::uint32_t where, const world::Instance& instance,
             const Vec3& origin);
    void build();
    void clear();
    [[nodiscard]] const Bodies& at(std::uint32_t where) const { return bodies_[where]; }
    [[nodiscard]] bool empty() const { return used_.empty(); }

private:
    std::vector<Bodies> bodies_;
    std::vector<std::uint32_t> used_;
    std::vector<std::uint8_t> isUsed_;
};

/// What a Scene has made of its world and moment.
struct SceneData {
    SceneData(const world::World& of, const RuleOptions& with);
    void takeMoment(const world::Moment& moment);

    const world::World& world;
    const RuleOptions options;
    /// All coordinates inside the scene are relative to it: the same blocks elsewhere on the map give the same numbers.
    const Vec3 origin;
    const Openings openings;

    BodyTable fixed, fixedByZone;        ///< what the world holds; the second only by choice
    BodyTable moving, movingByZone;      ///< what the moment holds
    std::vector<std::uint8_t> shut;      ///< by portal; empty: all open
    std::vector<std::uint32_t> fillings; ///< by portal: index into fillingSurfaces, or kNone; empty: none
    std::vector<TriangleSet> fillingSurfaces;

private:
    void addBodies(const world::Instance& instance, world::SpaceIndex space, BodyTable& bySpace);
    void addByZone(std::span<const world::Instance> instances, std::span<const world::SpaceIndex> members,
                   BodyTable& byZone);
    void takeFillings(const world::Moment& moment);
    [[nodiscard]] bool goesByZone(const world::Instance& instance) const;
};

struct Scene::Data : SceneData {
    using SceneData::SceneData;
};

} // namespace limen::reference
