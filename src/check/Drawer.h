#pragma once

#include "check/SampledComparison.h"
#include "check/View.h"
#include "core/Error.h"
#include "world/DynamicState.h"

#include <memory>

namespace limen::check {

/// What draws the views of a run: the renderer, or a test's stand-in. Called from the thread that made it.
class Drawer {
public:
    virtual ~Drawer() = default;

    /// Yields what was loaded; it stays as it is for as long as somebody holds it.
    [[nodiscard]] virtual Result<std::shared_ptr<const world::World>> load(dat::BlockCoord block) = 0;
    /// Says what will be loaded next, so that it may be read while views of the block before are drawn.
    virtual void expect(dat::BlockCoord) {}
    /// The view's axes, as they are drawn.
    [[nodiscard]] virtual reference::Camera cameraOf(const View& view, world::SpaceIndex root) = 0;
    /// Draws a view of the loaded world: ids and depth, and where `colour` is set colour. Or, all views alike, a multisampled
    /// picture: colour, flat by id, and where its samples lie.
    [[nodiscard]] virtual Result<DrawnImages> draw(const View& view, world::SpaceIndex root, bool colour) = 0;
    /// What an id's colour is in a flat picture; for drawers of multisampled ones.
    [[nodiscard]] virtual IdColour idColour() const { return nullptr; }
    /// Where everything was in the picture drawn last.
    [[nodiscard]] virtual const world::DynamicState& dynamics() const = 0;
    /// Makes another drawer that draws the same, for the thread that calls, of whatever this one has loaded last: its own load()
    /// takes that over, and this one loads nothing new meanwhile. Null if it has none to offer.
    [[nodiscard]] virtual Result<std::unique_ptr<Drawer>> makeHelper() { return nullptr; }
};

} // namespace limen::check
