#pragma once

#include "visibility/FloodTrace.h"
#include "visibility/Graph.h"
#include "visibility/View.h"
#include "visibility/VisibleSet.h"

#include <memory>

namespace limen::visibility {

/// Working memory of a flood. Give each thread its own and reuse it, so that a steady frame allocates
/// nothing.
class LIMEN_API FloodScratch {
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

/// Follows every ray of the view through the graph's portals and finds the tree of visits (docs/ray-rule.md).
/// A pure function: the same input gives the same bits. `closed[p] != 0` closes portal p; an empty span means
/// that all are open. `out` is overwritten. With a `trace`, which is overwritten, every portal of the spaces
/// that are seen gets an entry; the trace changes nothing else, but allocates.
///
/// Cost: portals tested times a convex clip. Errors: BadArgument, with `out` empty, for a root that is not a
/// space of the graph, an eye that is not finite, axes that are not orthonormal, tangents that are not positive
/// and finite, and a wrong length of `closed`. Ref: Luebke, Georges, "Portals and Mirrors" (1995).
[[nodiscard]] LIMEN_API Result<void> flood(const Graph& graph, std::span<const std::uint8_t> closed,
                                           const View& view, const Limits& limits, FloodScratch& scratch,
                                           VisibleSet& out, FloodTrace* trace = nullptr);

} // namespace limen::visibility
