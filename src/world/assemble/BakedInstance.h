#pragma once

#include "world/assemble/JoiningBlock.h"
#include "world/mesh/MeshArena.h"

namespace limen::world {

/// The identity of a record's own geometry (shell, terrain). Objects of the record count up from 0.
[[nodiscard]] constexpr std::uint64_t wholeObject(dat::RecordId record) {
    return static_cast<std::uint64_t>(record) << 32 | 0xFFFFFFFFu;
}

/// Adds a block-local mesh and an instance of it, outdoors, with the identity as transform. The reference is
/// valid until the next instance is added.
Instance& addBakedInstance(const JoiningBlock& block, InstanceKind kind, const MeshData& data,
                           std::uint64_t contentKey, MeshArena& arena, World& world);

} // namespace limen::world
