#pragma once

#include "frame/FramePlan.h"
#include "frame/FrameView.h"
#include "visibility/VisibleSet.h"
#include "world/World.h"

#include <limits>
#include <vector>

namespace limen::frame {

/// The greatest number of a rectangle that a RectRun can begin with.
inline constexpr std::size_t kMaxFirstRect = std::numeric_limits<std::uint16_t>::max();

/// The rectangle around a visit's region, NDC: minimum x and y, maximum x and y. It exceeds the region by two pixels, which
/// covers the difference between the region and the pixels that the visit owns.
[[nodiscard]] gpu::vec4 rectAround(const FrameView& frame, const visibility::VisibleSet& set,
                                   const visibility::Visit& visit);

/// The screen rectangles in which each zone is visible: one around the region of each visit to it. The
/// ownership test discards every fragment outside them of an instance that is a member of that zone only, so
/// the device culls its triangles there. Reuse it: steady frames allocate nothing.
class ZoneScreenRects {
public:
    /// `zoneCount`: of the world.
    explicit ZoneScreenRects(std::size_t zoneCount) : zones_(zoneCount) {}

    /// Writes the plan's rectangles. None if there is one visit: it has the whole picture.
    void find(const FrameView& frame, const visibility::VisibleSet& set, FramePlan& plan);
    /// The rectangles of a zone in the last call of `find`. None for kNone, for a zone without a visit, and
    /// for one that has the whole picture.
    [[nodiscard]] RectRun of(world::ZoneIndex zone) const {
        return zone != world::kNone && zones_[zone].frame == frame_ ? zones_[zone].rects : RectRun();
    }

    /// Maximum number per zone. The last one includes those of all further visits.
    static constexpr std::uint16_t kMostRects = 8;

private:
    struct OfZone {
        std::uint32_t frame = 0; ///< that `rects` are of
        RectRun rects;
    };
    struct Entry {
        world::ZoneIndex zone = 0;
        std::uint32_t visit = 0;
    };
    std::vector<OfZone> zones_;
    std::vector<Entry> entries_;
    std::uint32_t frame_ = 0;
};

} // namespace limen::frame
