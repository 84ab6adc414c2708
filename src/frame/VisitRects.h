#pragma once

#include "frame/FramePlan.h"
#include "frame/FrameView.h"
#include "visibility/VisibleSet.h"
#include "world/World.h"

#include <vector>

namespace limen::frame {

/// Where on the screen the zones of a frame's visits are seen: around each visit's region a rectangle. Of what is a member of one zone
/// alone every fragment elsewhere is dropped by the ownership test, so that triangles which lie elsewhere need not be drawn. Reuse it: steady
/// frames allocate nothing.
class VisitRects {
public:
    /// `zoneCount`: of the world.
    explicit VisitRects(std::size_t zoneCount) : ofZone_(zoneCount) {}

    /// Writes the plan's rectangles. Nothing where there is one visit: it has the whole picture.
    void find(const FrameView& frame, const visibility::VisibleSet& set, FramePlan& plan);
    /// Those of a zone (kNone: none), found last: none if it has the whole picture, or no visit.
    [[nodiscard]] RectRun of(world::ZoneIndex zone) const {
        return zone != world::kNone && ofZone_[zone].frame == frame_ ? ofZone_[zone].rects : RectRun();
    }

    /// Most for a zone: of the others the last holds all.
    static constexpr std::uint16_t kMostRects = 8;

private:
    struct OfZone {
        std::uint32_t frame = 0; ///< in which they were found
        RectRun rects;
    };
    struct Entry {
        world::ZoneIndex zone = 0;
        std::uint32_t visit = 0;
    };
    std::vector<OfZone> ofZone_;
    std::vector<Entry> entries_;
    std::uint32_t frame_ = 0;
};

} // namespace limen::frame
