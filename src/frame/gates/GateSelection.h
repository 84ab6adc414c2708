#pragma once

#include "frame/DynamicPieces.h"
#include "frame/Selection.h"

#include <span>
#include <vector>

namespace limen::frame {

/// A part of a frame: the instances that are seen in some of its visits.
struct SelectedPart {
    std::vector<std::uint32_t> surfaces; ///< walls and ground: positions of Clusters::order, ascending
    std::vector<PositionRange> objects;  ///< all other static instances, in order
    std::vector<SelectedDynamic> dynamics;
};

/// Whether a gate clips an instance of this kind by the regions of its space. All others are objects, which are
/// drawn whole.
[[nodiscard]] constexpr bool isClipped(world::InstanceKind kind) {
    return kind == world::InstanceKind::Shell || kind == world::InstanceKind::Exterior ||
           kind == world::InstanceKind::Terrain;
}

/// Selects the instances of the parts of one frame, each by the visits that it is seen in. An instance can be in
/// several parts. Reuse it. The scene must outlive it.
class GateSelection {
public:
    explicit GateSelection(const StaticScene& scene) : scene_(scene), selection_(scene) {}

    /// Starts a frame. All arguments must stay unchanged until its last part is selected.
    void begin(const FrameView& frame, const world::DynamicState& dynamics,
               const visibility::VisibleSet& set);
    /// Overwrites `part` with the instances seen in these visits.
    void select(std::span<const std::uint32_t> visits, SelectedPart& part);
    /// Of all parts since `begin`. An instance of several parts counts several times.
    [[nodiscard]] const Selection::Counts& counts() const { return counts_; }

private:
    const StaticScene& scene_;
    Selection selection_;
    const FrameView* frame_ = nullptr;
    const world::DynamicState* dynamics_ = nullptr;
    visibility::VisibleSet set_;                 ///< the frame's, with the seen spaces of one part
    std::vector<visibility::SeenSpace> allSeen_; ///< of the frame
    std::vector<std::uint8_t> isWanted_;         ///< by visit
    Selection::Counts counts_;
};

} // namespace limen::frame
