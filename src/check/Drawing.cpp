#include "check/Drawing.h"

#include "core/Assert.h"
#include "world/Loader.h"

#include <chrono>

namespace limen::check {

namespace {

world::SpaceIndex rootOf(const world::World& world, const View& view) {
    return view.root == 0 ? world::kOutside : world::findCell(world, view.root);
}

Result<DrawnView> drawView(Drawer& drawer, const world::World& world, const View& view) {
    using Clock = std::chrono::steady_clock;
    DrawnView drawn;
    drawn.view = view;
    const world::SpaceIndex root = rootOf(world, view);
    LIMEN_ASSERT(root != world::kNone, "the root of a view is in the loaded world");
    drawn.camera = drawer.cameraOf(view, root);
    const bool still = view.kind == ViewKind::Still;
    const Clock::time_point start = Clock::now();
    Result<DrawnImages> images = drawer.draw(view, root, still);
    if (!images)
        return Failure(images.error());
    drawn.images = std::move(*images);
    drawn.dynamics = drawer.dynamics();
    if (still) {
        const Result<DrawnImages> again = drawer.draw(view, root, true);
        if (!again)
            return Failure(again.error());
        drawn.moved = pixelsThatMoved(drawn.images, *again);
    }
    drawn.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return drawn;
}

} // namespace

Result<void> drawAll(ViewQueue& queue, Drawer& drawer, Judging& judging,
                     const std::function<Result<void>(std::size_t index)>& drawn) {
    for (std::size_t index = queue.take(); index < queue.views().size(); index = queue.take()) {
        Result<DrawnView> view = drawView(drawer, queue.world(), queue.views()[index]);
        Result<void> reported;
        if (view) {
            judging.add(index, std::move(*view));
            reported = drawn ? drawn(index) : Result<void>{};
        }
        if (!view || !reported) {
            queue.close();
            judging.giveUp();
            return Failure(view ? reported.error() : view.error());
        }
    }
    return {};
}

} // namespace limen::check
