#pragma once

#include "frame/Clusters.h"
#include "frame/FrameView.h"
#include "frame/GpuLayout.h"
#include "frame/LevelSelection.h"
#include "visibility/Viewcone.h"
#include "visibility/VisibleSet.h"
#include "world/DynamicState.h"

namespace limen::frame {

/// What stands still and is drawn: positions of Clusters::order.
struct SelectedRange {
    std::uint32_t first = 0, end = 0;
    bool gated = false;
    world::ZoneIndex zone =
        world::kNone; ///< where there are several visits: all are members of this one alone
};

/// What moves and is drawn: a place of Moment::listed; and gpu::kGated.
using SelectedMover = std::uint32_t;

/// Chooses what of a world is drawn in a frame: each member of a space that is seen, if its ball may show in a visit to that
/// space, within the part of the screen that the flood tells. One is gated unless it lies wholly within one visit, before all that
/// may hide it (Viewcones::classify), and is a member of one zone; with a single visit none is. Instances of clusters that lie wholly
/// within, or outside, are not asked one by one: the answer is the same. Only where the picture's edges alone cut a cluster ahead, with
/// a single visit, are those of its instances drawn, too, that lie beyond: they show nothing.
///
/// Reuse it: steady frames allocate nothing. World and clusters must outlive it.
class Selection {
public:
    Selection(const world::World& world, const Clusters& clusters);

    void select(const FrameView& frame, const world::DynamicState& dynamics,
                const visibility::VisibleSet& set);

    [[nodiscard]] std::span<const SelectedRange> ranges() const { return ranges_; } ///< in order, apart
    [[nodiscard]] std::span<const SelectedMover> movers() const {
        return std::span(movers_).first(moverCount_);
    } ///< in the order of Moment::instances

    /// Of the members of spaces that are seen, each once.
    struct Counts {
        std::uint32_t met = 0, drawn = 0, ungated = 0;
        std::uint32_t boundsTested = 0; ///< balls that were held against a visit
    };
    [[nodiscard]] const Counts& counts() const { return counts_; }

private:
    using Containment = visibility::Containment;
    /// A SeenSpace as a question.
    struct Ask {
        std::uint32_t space = 0, visit = 0;
        std::uint32_t next = world::kNone; ///< the next about the same space
        bool first = false;                ///< about its space
        bool narrow = false;               ///< `rect` may leave out part of the visit's region
        visibility::FourEdges rect;
    };
    /// The asks about one space.
    struct Asked {
        world::SpaceIndex space = 0;
        std::uint32_t firstAsk = 0;
    };
    /// What was found out about an instance that several spaces list.
    struct Mark {
        std::uint32_t frame = 0; ///< the last frame that met it
        Containment seen = Containment::Outside;
    };

    void selectStanding(const Asked& asked, std::uint32_t root);
    void gatherAsks(const visibility::VisibleSet& set);
    [[nodiscard]] visibility::SeenSphere sphereOf(const Sphere& global) const {
        return cones_.sphereOf({global.centre - eye_, global.radius});
    }
    /// Inside: so are all balls within this one.
    [[nodiscard]] Containment askCluster(const Ask& ask, const visibility::SeenSphere& sphere);
    /// Of a single instance, which may reach out of the rectangle.
    [[nodiscard]] Containment askInstance(const Ask& ask, const visibility::SeenSphere& sphere);
    void descend(const Cluster& cluster, std::size_t firstActive);
    void selectLeaf(const Cluster& leaf, std::size_t firstActive);
    /// What moves, and what several spaces list.
    void selectListed(const Ask& ask, const world::DynamicState& dynamics);
    void selectMoversOf(const Ask& ask, const world::DynamicState& dynamics);
    /// Yields whether it is the first time in this frame.
    bool meet(const Ask& ask, const Sphere& bounds, Mark& mark);
    void selectOneByOne(const Ask& ask, const world::DynamicState& dynamics, std::uint32_t first,
                        std::uint32_t end);
    void meetListed(const Ask& ask, const world::DynamicState& dynamics, std::uint32_t at);
    void finishListed(const world::DynamicState& dynamics);
    void draw(std::uint32_t first, std::uint32_t end, bool inside);
    void drawMover(std::uint32_t at, bool inside);

    const world::World& world_;
    const Clusters& clusters_;
    std::vector<std::uint8_t> sharedInOneZone_; ///< by position from Clusters::firstShared on
    LevelSelection levels_;
    visibility::Viewcones cones_;
    Vec3 eye_{0.0}, forward_{0.0};
    double nearPlane_ = 0.0;
    bool several_ = false;                 ///< visits
    world::ZoneIndex zone_ = world::kNone; ///< of what is drawn next (SelectedRange)
    bool everyAsk_ = false;                ///< Rules::viewcone
    std::uint32_t frameNumber_ = 0;
    std::vector<Ask> asks_; ///< by VisibleSet::seen
    std::vector<Asked> asked_;
    std::vector<std::uint32_t> askedFrame_; ///< by space: the last frame that asked about it
    std::vector<std::uint32_t> lastAsk_;    ///< by space
    std::vector<std::uint32_t>
        active_; ///< a stack of asks that a cluster, and those around it, did not settle
    std::vector<Mark> sharedMarks_, moverMarks_;
    std::vector<std::uint32_t> sharedMet_, moversMet_;
    std::vector<SelectedRange> ranges_;
    std::vector<SelectedMover> movers_; ///< the first moverCount_: it stays as long as it has to be
    std::size_t moverCount_ = 0;
    Counts counts_;
};

} // namespace limen::frame
