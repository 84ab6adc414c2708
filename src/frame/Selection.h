#pragma once

#include "frame/FramePlan.h"
#include "frame/FrameView.h"
#include "frame/InstanceLevels.h"
#include "frame/LevelSelection.h"
#include "frame/Occluders.h"
#include "frame/RootExits.h"
#include "frame/StaticScene.h"
#include "visibility/Viewcone.h"
#include "visibility/VisibleSet.h"
#include "world/DynamicState.h"

namespace limen::frame {

/// Visible static instances: positions of Clusters::order.
struct SelectedRange {
    std::uint32_t first = 0, end = 0;
    bool gated = false;
    bool inRange = false;    ///< the eye is known to be in range of all levels of detail
    Turn turn = Turn::After; ///< for FrameView::rootFirst
    /// With several visits: the only zone that all of them are members of. Else kNone.
    world::ZoneIndex zone = world::kNone;
};

/// A visible dynamic instance: its position in DynamicState::listed, and gpu::kGated.
using SelectedDynamic = std::uint32_t;

/// Selects the instances to draw in a frame: the members of spaces that are seen whose bounding sphere can be
/// visible in a visit to that space, within the rectangle that the flood found for the space. An instance is
/// gated unless it is wholly within one visit, in front of every surface that can hide it
/// (Viewcones::classify), and a member of one zone. With a single visit nothing is gated.
///
/// Instances out of the range of their levels of detail are left out, but with a single visit only clusters all of whose instances
/// are. The drawing leaves out others (DrawRecords::isInRange).
///
/// Instances of clusters wholly inside or outside are not tested one by one; the result is the same. There is
/// one exception: with a single visit, a leaf cluster ahead of the eye that crosses the picture's edges is
/// drawn whole.
///
/// Reuse it: steady frames allocate nothing. The scene must outlive it.
class Selection {
public:
    explicit Selection(const StaticScene& scene);

    /// `rootFirst`: the plan draws the root by itself, without the ownership test (FrameView::rootFirst).
    void select(const FrameView& frame, const world::DynamicState& dynamics,
                const visibility::VisibleSet& set, bool rootFirst = false);

    [[nodiscard]] std::span<const SelectedRange> ranges() const { return ranges_; } ///< in order, disjoint
    /// In the order of DynamicState::instances.
    [[nodiscard]] std::span<const SelectedDynamic> dynamicInstances() const {
        return std::span(dynamic_).first(dynamicCount_);
    }

    /// Of the members of spaces that are seen, each once.
    struct Counts {
        std::uint32_t tested = 0, drawn = 0, ungated = 0;
        std::uint32_t hidden = 0;       ///< of a visible visit, and left out because occluders hide them
        std::uint32_t boundsTested = 0; ///< tests of a bounding sphere against a visit
    };
    [[nodiscard]] const Counts& counts() const { return counts_; }

private:
    using Containment = visibility::Containment;
    /// The test for one SeenSpace: a visit and a rectangle.
    struct SpaceTest {
        std::uint32_t space = 0, visit = 0;
        std::uint32_t next = world::kNone; ///< the next test of the same space
        bool isFirst = false;              ///< of its space
        bool isNarrow = false;             ///< `rect` may exclude part of the visit's region
        visibility::FourEdges rect;
    };
    struct TestedSpace {
        world::SpaceIndex space = 0;
        std::uint32_t firstTest = 0;
    };
    /// The result so far for an instance that several spaces list.
    struct SharedResult {
        std::uint32_t frame = 0; ///< the last frame that tested it
        Containment seen = Containment::Outside;
    };

    void gatherTests(const visibility::VisibleSet& set);
    void selectStatic(const TestedSpace& tested, std::uint32_t root);
    [[nodiscard]] visibility::SeenSphere sphereOf(const Sphere& global) const {
        return cones_.sphereOf({global.centre - eye_, global.radius});
    }
    /// Inside means that every sphere within this one is inside, too.
    [[nodiscard]] Containment testCluster(const SpaceTest& test, const visibility::SeenSphere& sphere);
    /// For a single instance: it may be Inside although it extends beyond the rectangle.
    [[nodiscard]] Containment testInstance(const SpaceTest& test, const visibility::SeenSphere& sphere);
    /// The same for a static instance that one space lists: walls are tested by their vertices.
    [[nodiscard]] Containment testStatic(const SpaceTest& test, std::uint32_t position,
                                         const visibility::SeenSphere& sphere);
    /// The same for the root visit, which is drawn by itself: Inside if it shows the instance, because nothing takes a test.
    [[nodiscard]] Containment testInRoot(const SpaceTest& test, std::uint32_t position,
                                         const visibility::SeenSphere& sphere);
    /// Whether visits other than the root, of active tests up to `end`, reach a sphere. Tests before `begin` are done; those that reach
    /// it are active from `end` on.
    [[nodiscard]] bool othersReach(std::size_t begin, std::size_t end, const visibility::SeenSphere& sphere);
    /// The visits that show a static instance: Outside if none does.
    struct Showing {
        Containment best = Containment::Outside;
        Turn turn = Turn::After;
    };
    [[nodiscard]] Showing showingOf(std::uint32_t position, std::size_t firstActive);
    [[nodiscard]] Showing showingBesideRoot(std::uint32_t position, std::size_t firstActive);
    /// Draws a cluster that is Inside a visit.
    void drawInRange(const Cluster& cluster, Turn turn);
    /// Draws the instances of a cluster that is Inside the root visit and not hidden as a whole.
    void drawUnhidden(const Cluster& cluster);
    void descend(const Cluster& cluster, std::size_t firstActive);
    void selectLeaf(const Cluster& leaf, std::size_t firstActive);
    /// Selects the dynamic instances, and the static ones that several spaces list.
    void selectListed(const SpaceTest& test, const world::DynamicState& dynamics);
    /// Requires a single visit.
    void selectBatches(const SpaceTest& test, const world::DynamicState& dynamics);
    void selectOneByOne(const SpaceTest& test, const world::DynamicState& dynamics, std::uint32_t first,
                        std::uint32_t end);
    /// Returns whether this is the instance's first test in this frame.
    bool testShared(const SpaceTest& test, const Sphere& bounds, SharedResult& result);
    void testSharedDynamic(const SpaceTest& test, const world::DynamicState& dynamics, std::uint32_t at);
    void finishListed(const world::DynamicState& dynamics);
    void draw(const PositionRange& range, bool inside, Turn turn, bool inRange = true);
    void draw(std::uint32_t position, bool inside, Turn turn) {
        draw({position, position + 1}, inside, turn);
    }
    void drawDynamic(std::uint32_t at, bool inside);

    const world::World& world_;
    const Clusters& clusters_;
    LevelSelection levels_;
    LevelTests inRange_;
    RootExits exits_;
    Occluders occluders_;
    visibility::Viewcones cones_;
    Vec3 eye_{0.0}, forward_{0.0};
    double nearPlane_ = 0.0;
    world::LevelShare levelShare_;
    bool hasSeveralVisits_ = false;
    world::ZoneIndex zone_ = world::kNone; ///< SelectedRange::zone of the next ranges
    bool hasFewTests_ = false;             ///< FrameView::fewTests
    bool hasTurns_ = false;                ///< the root is drawn by itself
    bool testsEveryVisit_ = false;         ///< Rules::viewcone
    std::uint32_t frameNumber_ = 0;
    std::vector<SpaceTest> tests_; ///< by VisibleSet::seen
    std::vector<TestedSpace> testedSpaces_;
    std::vector<std::uint32_t> testedFrame_; ///< by space: the last frame that tested it
    std::vector<std::uint32_t> lastTest_;    ///< by space
    std::vector<std::uint32_t>
        active_; ///< a stack of tests that were partial for a cluster and its ancestors
    std::vector<SharedResult> sharedResults_, dynamicResults_;
    std::vector<std::uint32_t> sharedTested_,
        dynamicTested_; ///< numbers of shared instances; positions of listed
    std::vector<SelectedRange> ranges_;
    std::vector<SelectedDynamic> dynamic_; ///< the first dynamicCount_ are in use
    std::size_t dynamicCount_ = 0;
    Counts counts_;
};

} // namespace limen::frame
