#pragma once

#include "visibility/FloodTrace.h"
#include "visibility/Graph.h"
#include "visibility/View.h"
#include "visibility/VisibleSet.h"

#include <memory>

namespace limen::visibility {

/// Memory that a flood works in; give each thread its own and reuse it, so that a steady frame allocates
/// nothing.
class FloodScratch {
public:
    FloodScratch();
    ~FloodScratch();
    FloodScratch(FloodScratch&&) noexcept;
    FloodScratch& operator=(FloodScratch&&) noexcept;

    struct Data;
    [[nodiscard]] Data& data() { return *data_; }

private:
    std::unique_ptr<Data> data_;
};

/// Follows every ray of the view through the graph's portals and yields the tree of visits
/// (docs/ray-rule.md#why-one-pass-over-the-scene-is-enough). A pure function: the same input gives the same
/// bits. `closed[p] != 0` shuts portal p; an
/// empty span means all are open. `out` is overwritten. Requires view.root < spaces, finite eye. Cost:
/// portals tested times a convex clip. Ref: portal floods after Luebke, Georges, "Portals and Mirrors"
/// (1995); the tree of visits: docs/ray-rule.md. With a `trace`, which is overwritten, every portal of the spaces that are seen gets an
/// entry; it changes nothing else, and costs allocations.
void flood(const Graph& graph, std::span<const std::uint8_t> closed, const View& view, const Limits& limits,
           FloodScratch& scratch, VisibleSet& out, FloodTrace* trace = nullptr);

} // namespace limen::visibility
