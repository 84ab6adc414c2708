#pragma once

#include "dat/File.h"

namespace limen::dat {

/// A planned node: its entries and, for an inner node, the indices of its children, one more than entries.
struct NodePlan {
    std::vector<Entry> entries;
    std::vector<std::size_t> children;
};

/// The nodes of a balanced B-tree over `entries` (ascending, unique), children before parents, the root last;
/// none for no entries. Method: docs/formats/container.md#writing-a-file.
[[nodiscard]] std::vector<NodePlan> planTree(const std::vector<Entry>& entries);

} // namespace limen::dat
