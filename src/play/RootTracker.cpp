#include "play/RootTracker.h"

#include "motion/Locate.h"

namespace limen::play {

bool RootTracker::isLost(const world::World& world, const Vec3& eye) const {
    if (root_ == world::kOutside)
        return motion::locate(world, eye).space != world::kOutside;
    // A cell without a BSP tree cannot classify a position: trust the sweep.
    return world.spaces[root_].bspNodeCount > 0 && !motion::cellContains(world, root_, eye);
}

world::SpaceIndex RootTracker::move(const world::World& world, const Vec3& from, const Vec3& to,
                                    double seconds) {
    root_ = motion::sweep(world, root_, from, to);
    lostSeconds_ = isLost(world, to) ? lostSeconds_ + seconds : 0.0;
    if (lostSeconds_ > kGraceSeconds)
        place(motion::locate(world, to).space);
    return root_;
}

} // namespace limen::play
