#pragma once

#include "visibility/VisibleSet.h"
#include "world/World.h"

#include <vector>

namespace limen::frame {

/// The openings by which rays leave the root visit. A wall of the root's zone that lies before all of them
/// passes the ownership test at every pixel: the root is in every pixel's chain of visits. Only with
/// FrameView::fewTests. Reuse it: steady frames allocate nothing.
class RootExits {
public:
    /// `world` must outlive it.
    explicit RootExits(const world::World& world) : world_(world), known_(kKnown) {}

    void prepare(const visibility::VisibleSet& set);
    /// Whether a cell's own walls lie before all exits, by their vertices: an opening's plane touches the
    /// walls around it, and so the sphere around them.
    [[nodiscard]] bool areBeyond(world::InstanceIndex shell);

private:
    /// The result for a shell and a portal, both static.
    struct Known {
        world::InstanceIndex shell = world::kNone;
        world::PortalIndex portal = world::kNone;
        bool isBefore = false;
    };
    static constexpr std::size_t kKnown = 4096; ///< a power of two
    [[nodiscard]] bool isBefore(world::InstanceIndex shell, world::PortalIndex portal);

    const world::World& world_;
    std::vector<const visibility::Visit*> exits_; ///< of the set that was prepared last
    std::vector<Known> known_;                    ///< by a hash of both
};

} // namespace limen::frame
