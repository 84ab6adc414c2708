#include "frame/gates/GateSelection.h"

#include <algorithm>

namespace limen::frame {

void GateSelection::begin(const FrameView& frame, const world::DynamicState& dynamics,
                          const visibility::VisibleSet& set) {
    frame_ = &frame;
    dynamics_ = &dynamics;
    set_.visits = set.visits;
    set_.regionVertices = set.regionVertices;
    allSeen_ = set.seen;
    counts_ = {};
}

void GateSelection::select(std::span<const std::uint32_t> visits, SelectedPart& part) {
    isWanted_.assign(set_.visits.size(), 0);
    for (const std::uint32_t visit : visits)
        isWanted_[visit] = 1;
    set_.seen.clear();
    std::copy_if(allSeen_.begin(), allSeen_.end(), std::back_inserter(set_.seen),
                 [&](const visibility::SeenSpace& seen) { return isWanted_[seen.visit] != 0; });
    selection_.select(*frame_, *dynamics_, set_);
    part.surfaces.clear();
    part.objects.clear();
    const world::World& world = scene_.world();
    for (const SelectedRange& range : selection_.ranges()) {
        for (std::uint32_t at = range.first; at < range.end; ++at)
            if (isClipped(world.instances[scene_.clusters().order[at]].kind))
                part.surfaces.push_back(at);
            else if (!part.objects.empty() && part.objects.back().end == at)
                ++part.objects.back().end;
            else
                part.objects.push_back({at, at + 1});
    }
    part.dynamics.assign(selection_.dynamicInstances().begin(), selection_.dynamicInstances().end());
    for (SelectedDynamic& dynamic : part.dynamics)
        dynamic &= ~gpu::kGated; // there is no ownership test
    const Selection::Counts& counts = selection_.counts();
    counts_.tested += counts.tested;
    counts_.drawn += counts.drawn;
    counts_.boundsTested += counts.boundsTested;
}

} // namespace limen::frame
