#pragma once

#include "check/SampledComparison.h"
#include "check/View.h"
#include "core/Error.h"
#include "world/DynamicState.h"

#include <memory>

namespace limen::check {

/// The interface to the renderer of a run's views, or to a test's substitute. All calls come from the thread
/// that made it.
class Drawer {
public:
    virtual ~Drawer() = default;

    /// Loads the world around a block. The result never changes while it is held.
    [[nodiscard]] virtual Result<std::shared_ptr<const world::World>> load(dat::BlockCoord block) = 0;
    /// Announces the next load, which may be prefetched while views of the current block are drawn.
    virtual void expect(dat::BlockCoord) {}
    /// The camera with which the view is drawn.
    [[nodiscard]] virtual reference::Camera cameraOf(const View& view, world::SpaceIndex root) = 0;
    /// Draws a view of the loaded world: ids and depth, and colour if `colour` is set. A drawer of
    /// multisampled pictures draws all views as colour, flat by id, with the sample positions.
    [[nodiscard]] virtual Result<DrawnImages> draw(const View& view, world::SpaceIndex root, bool colour) = 0;
    /// The colour of each id in flat pictures, for drawers of multisampled pictures; else null.
    [[nodiscard]] virtual IdColour idColour() const { return nullptr; }
    /// The dynamic state of the last picture.
    [[nodiscard]] virtual const world::DynamicState& dynamics() const = 0;
    /// Makes a second drawer with equal results, for the calling thread. Its load() takes over the world that
    /// this drawer loaded last; this drawer must not load meanwhile. Null if it has no helper.
    [[nodiscard]] virtual Result<std::unique_ptr<Drawer>> makeHelper() { return nullptr; }
};

} // namespace limen::check
