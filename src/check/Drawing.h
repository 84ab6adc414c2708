#pragma once

#include "check/Drawer.h"
#include "check/Judging.h"

#include <atomic>
#include <span>

namespace limen::check {

/// The views of one loaded block, handed out to whoever draws. Any thread may take.
class ViewQueue {
public:
    ViewQueue(const world::World& world, std::span<const View> views, std::size_t first)
        : world_(world), views_(views), next_(first) {}

    /// The index of a view that nobody has drawn yet; none are left: views().size() or more.
    [[nodiscard]] std::size_t take() { return next_++; }
    /// Hands out no more.
    void close() { next_ = views_.size(); }

    [[nodiscard]] const world::World& world() const { return world_; }
    [[nodiscard]] std::span<const View> views() const { return views_; }

private:
    const world::World& world_;
    std::span<const View> views_;
    std::atomic<std::size_t> next_;
};

/// Takes views, draws them and hands them on until there are no more, or one fails: then the queue is closed. `drawn` is told
/// of each. Errors: the drawer's.
[[nodiscard]] Result<void> drawAll(ViewQueue& queue, Drawer& drawer, Judging& judging,
                                   const std::function<Result<void>(std::size_t index)>& drawn = {});

} // namespace limen::check
