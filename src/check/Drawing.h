#pragma once

#include "check/Drawer.h"
#include "check/Judging.h"

#include <atomic>
#include <span>

namespace limen::check {

/// Distributes the views of one loaded block among drawers. Safe to use from any thread.
class ViewQueue {
public:
    ViewQueue(const world::World& world, std::span<const View> views, std::size_t first)
        : world_(world), views_(views), next_(first) {}

    /// The index of the next view to draw; views().size() or more if none is left.
    [[nodiscard]] std::size_t take() { return next_++; }
    /// Makes take() find no further views.
    void close() { next_ = views_.size(); }

    [[nodiscard]] const world::World& world() const { return world_; }
    [[nodiscard]] std::span<const View> views() const { return views_; }

private:
    const world::World& world_;
    std::span<const View> views_;
    std::atomic<std::size_t> next_;
};

/// Draws the queue's views and passes them to `judging` until none is left. `drawn` is called after each. The
/// first error closes the queue. Errors: the drawer's and those of `drawn`.
[[nodiscard]] Result<void> drawAll(ViewQueue& queue, Drawer& drawer, Judging& judging,
                                   const std::function<Result<void>(std::size_t index)>& drawn = {});

} // namespace limen::check
