#pragma once

#include "frame/DynamicPieces.h"
#include "frame/FramePlan.h"
#include "frame/FrameView.h"
#include "frame/Selection.h"
#include "frame/StaticScene.h"
#include "frame/TransparentRuns.h"
#include "frame/ZoneScreenRects.h"
#include "visibility/VisibleSet.h"
#include "world/DynamicState.h"

#include <memory>
#include <optional>

namespace limen::frame {

class GatePlanner;

/// Plans the frames of one scene: selects the visible instances and writes them as stages, batches and runs.
/// Holds the memory for that, so that a steady frame allocates nothing. One planner per thread; the scene can
/// be shared.
class Planner {
public:
    /// `scene` must outlive the planner.
    explicit Planner(const StaticScene& scene);
    Planner(const Planner&) = delete;
    Planner& operator=(const Planner&) = delete;
    ~Planner();

    /// Plans one frame; `plan` is overwritten and refers to the instances of `dynamics`. `set` must be the
    /// flood of the same world and dynamic state from `frame.view`; for other gates than Gate::Ownership, of the
    /// graph in which every space is a zone (frame/WorldGraph.h).
    void plan(const FrameView& frame, const world::DynamicState& dynamics, const visibility::VisibleSet& set,
              FramePlan& plan);
    /// Plans a frame without dynamic instances.
    void plan(const FrameView& frame, const visibility::VisibleSet& set, FramePlan& plan) {
        this->plan(frame, {}, set, plan);
    }

private:
    void fillConstants(const FrameView& frame, const visibility::VisibleSet& set, FramePlan& plan) const;
    /// Places the lamps; the nearest ones shine.
    void placeLamps(const Vec3& eye, FramePlan& plan);
    void fillCounts(const visibility::VisibleSet& set, FramePlan& plan) const;
    void planSolid(bool several, FramePlan& plan);
    void addSolid(DrawClass drawn, bool several, FramePlan& plan);
    /// For FrameView::rootFirst. `openings`: rectangles that contain all pixels whose ray leaves the root.
    void planSolidRootFirst(const RectRun& openings, FramePlan& plan);
    /// `openings`: of the root, for an eye outside in a frame that fills voids; else voids may be anywhere.
    void planSky(const FrameView& frame, const visibility::VisibleSet& set,
                 const std::optional<RectRun>& openings, FramePlan& plan);
    static void planPlainSky(const visibility::VisibleSet& set, const std::optional<RectRun>& openings,
                             FramePlan& plan);
    void planTransparent(const Vec3& eye, bool several, const world::DynamicState& dynamics, FramePlan& plan);

    const StaticScene& scene_;
    const world::World& world_;
    const ResidentPieces& pieces_;
    Selection selection_;
    std::unique_ptr<GatePlanner> gates_; ///< of other gates than Gate::Ownership; made when first used
    ZoneScreenRects rects_;
    DynamicPieces dynamicPieces_; ///< of the frame
    TransparentRuns transparent_;
    bool isRootFirst_ = false; ///< FrameView::rootFirst counts in this frame
    std::vector<world::SkyPlacement> sky_;
    std::vector<std::pair<double, std::uint32_t>> lamps_; ///< squared distance from the eye, and number
};

} // namespace limen::frame
