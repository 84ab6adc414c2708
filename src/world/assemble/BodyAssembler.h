#pragma once

#include "world/assemble/Cycles.h"
#include "world/assemble/MaterialRuns.h"
#include "world/mesh/MeshArena.h"

namespace limen::world {

/// The top byte of the identity of a dynamic object. Identities of landblock objects never begin with 0xF.
enum class DynamicObject : std::uint64_t {
    Door = 0xF1,
    Villager = 0xF2,
    Sprite = 0xF3,
    Player = 0xF4,
    Particle = 0xF5,
    Placed = 0xF6
};
[[nodiscard]] constexpr std::uint64_t dynamicObject(DynamicObject kind, std::size_t index) {
    return static_cast<std::uint64_t>(kind) << 56 | static_cast<std::uint64_t>(index);
}

/// What a body has beside its model.
struct BodyOptions {
    double scale = 1.0;        ///< of the placed object: levels of detail change so much farther away
    bool isAlwaysNear = false; ///< only the nearest level of detail
    Dress dress{};
    dat::RecordId motionTable = 0; ///< in place of the Setup's own; 0: that one
};

/// Adds bodies to World::movingParts: the posed parts of one model, with the cycles that its Setup names.
class BodyAssembler {
public:
    BodyAssembler(Models& models, MaterialRuns& materials, Cycles& cycles, MeshArena& arena, World& world)
        : models_(models), materials_(materials), cycles_(cycles), arena_(arena), world_(world) {}

    /// A filling (a door leaf) gets neither cycles nor levels of detail: its hinge alone moves it, and it has
    /// the same shape at every distance.
    [[nodiscard]] MovingBody add(dat::RecordId model, InstanceKind kind, std::uint64_t object,
                                 const BodyOptions& options = {});
    /// A copy of a body whose surfaces are all blended, to fade it.
    [[nodiscard]] MovingBody addBlended(const MovingBody& solid);

private:
    [[nodiscard]] static std::vector<ModelPart> partsOf(const Model& model, bool nearestOnly);
    /// Requires: the body's parts are the last ones added.
    void addCycles(dat::RecordId model, dat::RecordId motionTable, std::span<const PosedPart> posed,
                   MovingBody& body);

    Models& models_;
    MaterialRuns& materials_;
    Cycles& cycles_;
    MeshArena& arena_;
    World& world_;
};

} // namespace limen::world
