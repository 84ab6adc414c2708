#pragma once

#include "world/assemble/IdleAssembler.h"
#include "world/assemble/Lights.h"
#include "world/assemble/Members.h"
#include "world/assemble/ParticleAssembler.h"

namespace limen::world {

/// Adds the statics and scenery of blocks to a World, with their lamps and particle sources.
class ObjectAssembler {
public:
    ObjectAssembler(IdleAssembler& idle, ParticleAssembler& particles, Models& models,
                    MaterialRuns& materials, MeshArena& arena, World& world)
        : idle_(idle), particles_(particles), models_(models), materials_(materials), arena_(arena),
          world_(world) {}

    void add(const JoiningBlock& block);
    void addObject(const PlacedModel& object, const ObjectSite& site);
    /// The object's lamps and particle sources alone. `idle`: its index in World::idleObjects; kNone if it does not move.
    void addEffects(const PlacedModel& object, std::uint32_t idle, const ObjectSite& site);

    /// The objects whose members are not found yet.
    [[nodiscard]] std::span<const ObjectGroup> groups() const { return groups_; }
    [[nodiscard]] std::span<const PlacedLamp> lamps() const { return lamps_; }

private:
    /// `bounds`: global.
    void addStatic(const PlacedModel& object, const Model& model, const Sphere& bounds,
                   const ObjectSite& site);
    void addPart(const PlacedModel& object, const ModelPart& part, const ObjectSite& site);

    IdleAssembler& idle_;
    ParticleAssembler& particles_;
    Models& models_;
    MaterialRuns& materials_;
    MeshArena& arena_;
    World& world_;
    std::vector<ObjectGroup> groups_;
    std::vector<PlacedLamp> lamps_;
};

} // namespace limen::world
