#include "frame/VisitBits.h"

#include "core/Assert.h"
#include "visibility/VisibleSet.h"

namespace limen::frame {

void VisitBits::prepare(const FramePlan& plan) {
    LIMEN_ASSERT(suffice(plan), "each visit has a bit");
    for (const std::uint32_t zone : zones_)
        bits_[zone] = 0;
    zones_.clear();
    for (std::uint32_t visit = 0; visit < plan.constants.visitCount; ++visit) {
        const std::uint32_t zone = plan.visits[visit].zone;
        if (zone == visibility::kNoZone) // a hole: no instance belongs to it
            continue;
        if (zone >= bits_.size())
            bits_.resize(std::size_t{zone} + 1);
        bits_[zone] |= std::uint64_t{1} << visit;
        zones_.push_back(zone);
    }
}

} // namespace limen::frame
