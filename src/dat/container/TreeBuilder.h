#pragma once

#include "dat/File.h"

namespace limen::dat {

/// A node to be written: its entries, and for an inner node the numbers of its children, one more than
/// entries.
struct NodePlan {
    std::vector<Entry> entries;
    std::vector<std::size_t> children;
};

/// The nodes of a balanced B-tree over `entries` (ascending, unique), children before parents, the root last.
/// None for no entries. Recipe: docs/formats/container.md#writing-a-file.
[[nodiscard]] std::vector<NodePlan> planTree(const std::vector<Entry>& entries);

} // namespace limen::dat
