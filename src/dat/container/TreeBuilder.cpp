#include "dat/container/TreeBuilder.h"

#include "dat/container/Format.h"

namespace limen::dat {
namespace {

/// One level of the tree: entries, and the nodes below between them (none for leaves).
struct Level {
    std::vector<Entry> entries;
    std::vector<std::size_t> children;
};

/// Spreads a level evenly over nodes. The entries between neighbouring nodes form the next level.
Level buildLevel(const Level& level, std::vector<NodePlan>& nodes) {
    const std::size_t n = level.entries.size();
    const std::size_t nodeCount = (n + kMaxBranches) / kMaxBranches; // ceil((n + 1) / 62)
    const std::size_t spread = n - (nodeCount - 1);
    Level above;
    std::size_t at = 0;
    for (std::size_t i = 0; i < nodeCount; ++i) {
        const std::size_t count = spread / nodeCount + (i < spread % nodeCount ? 1 : 0);
        NodePlan node;
        const auto first = level.entries.begin() + static_cast<std::ptrdiff_t>(at);
        node.entries.assign(first, first + static_cast<std::ptrdiff_t>(count));
        if (!level.children.empty()) {
            const auto child = level.children.begin() + static_cast<std::ptrdiff_t>(at);
            node.children.assign(child, child + static_cast<std::ptrdiff_t>(count + 1));
        }
        above.children.push_back(nodes.size());
        nodes.push_back(std::move(node));
        at += count;
        if (i + 1 < nodeCount)
            above.entries.push_back(level.entries[at++]);
    }
    return above;
}

} // namespace

std::vector<NodePlan> planTree(const std::vector<Entry>& entries) {
    std::vector<NodePlan> nodes;
    if (entries.empty())
        return nodes;
    Level level{entries, {}};
    do {
        level = buildLevel(level, nodes);
    } while (!level.entries.empty());
    return nodes;
}

} // namespace limen::dat
