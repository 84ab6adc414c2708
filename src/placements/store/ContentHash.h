#pragma once

#include "placements/Placements.h"

// Hashes of content. A second import compares them. They depend on every member.
namespace limen::placements {

[[nodiscard]] std::uint64_t hashOf(const Landblock& landblock);
[[nodiscard]] std::uint64_t hashOf(const Template& of);

} // namespace limen::placements
