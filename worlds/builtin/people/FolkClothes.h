#pragma once

#include "worlds/records/ModelWriter.h"

namespace limen::worlds {

/// Colours of a cloak, as palette templates of its ClothingTable.
inline constexpr std::uint32_t kUndyed = 1, kDyed = 2;

/// Adds a ClothingTable with a cloak, undyed or dyed, for part 0 of some Setups; returns its id. Requires:
/// the materials were added.
[[nodiscard]] dat::RecordId addCloak(ModelWriter& writer, const std::vector<dat::RecordId>& setups,
                                     dat::RecordId cloaked);

} // namespace limen::worlds
