#pragma once

#include "worlds/records/ModelWriter.h"

namespace limen::worlds {

/// Colours of a cloak, as palette templates of its ClothingTable.
inline constexpr std::uint32_t kUndyed = 1, kDyed = 2;

/// A ClothingTable that puts a cloak on part 0 of some Setups, and dyes it. Requires: the materials are there. Yields its id.
[[nodiscard]] dat::RecordId addCloak(ModelWriter& sink, const std::vector<dat::RecordId>& setups,
                                     dat::RecordId cloaked);

} // namespace limen::worlds
