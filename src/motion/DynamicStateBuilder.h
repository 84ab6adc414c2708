#pragma once

#include "motion/DynamicInstances.h"
#include "motion/DynamicStateInput.h"
#include "world/DynamicState.h"
#include "world/World.h"

namespace limen::motion {

/// Builds the dynamic state of a world: moving instances, the spaces that each belongs to, and the shut
/// portals. The result is a pure function of world and input. The builder keeps its memory, so steady frames
/// allocate nothing. The world must outlive the builder.
class DynamicStateBuilder {
public:
    explicit DynamicStateBuilder(const world::World& world) : world_(world), instances_(world) {}

    /// Overwrites `out`.
    void build(const DynamicStateInput& input, world::DynamicState& out);

private:
    const world::World& world_;
    DynamicInstances instances_;
};

} // namespace limen::motion
