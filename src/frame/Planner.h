#pragma once

#include "frame/DynamicPieces.h"
#include "frame/FramePlan.h"
#include "frame/FrameView.h"
#include "frame/Selection.h"
#include "frame/StaticScene.h"
#include "frame/ZoneScreenRects.h"
#include "visibility/VisibleSet.h"
#include "world/DynamicState.h"

namespace limen::frame {

/// Plans the frames of one scene: selects the visible instances and writes them as stages, batches and runs.
/// Holds the memory for that, so that a steady frame allocates nothing. One planner per thread; the scene can
/// be shared.
class Planner {
public:
    /// `scene` must outlive the planner.
    explicit Planner(const StaticScene& scene);
    Planner(const Planner&) = delete;
    Planner& operator=(const Planner&) = delete;

    /// Plans one frame; `plan` is overwritten and refers to the instances of `dynamics`. `set` must be the
    /// flood of the same world and dynamic state from `frame.view`.
    void plan(const FrameView& frame, const world::DynamicState& dynamics, const visibility::VisibleSet& set,
              FramePlan& plan);
    /// Plans a frame without dynamic instances.
    void plan(const FrameView& frame, const visibility::VisibleSet& set, FramePlan& plan) {
        this->plan(frame, {}, set, plan);
    }

private:
    /// The blended pieces of one instance.
    struct TransparentRun {
        double distance = 0.0; ///< from the eye to the nearest point of its bounds, metres
        std::uint32_t instance = 0;
        PieceRun run;
    };

    void fillConstants(const FrameView& frame, const visibility::VisibleSet& set, FramePlan& plan) const;
    /// Places the lamps; the nearest ones shine.
    void placeLamps(const Vec3& eye, FramePlan& plan);
    void fillCounts(const visibility::VisibleSet& set, FramePlan& plan) const;
    void planDynamic(const FrameView& frame, const world::DynamicState& dynamics, FramePlan& plan);
    void changeDynamic(const FrameView& frame, const world::DynamicState& dynamics, std::uint32_t instance,
                       FramePlan& plan) const;
    void planSolid(bool several, FramePlan& plan);
    void addSolid(DrawClass drawn, bool several, FramePlan& plan);
    void planSky(const FrameView& frame, const visibility::VisibleSet& set, FramePlan& plan);
    /// Adds the sky objects that are over the land, or the others, to the last batch.
    void addSkyObjects(bool overLand, FramePlan& plan);
    void planTransparent(const Vec3& eye, bool several, const world::DynamicState& dynamics, FramePlan& plan);
    /// Adds to `transparent_` from pieces of one class in which those of an instance are consecutive.
    /// `first`: number of the first piece; `boundsOf(instance)`: its bounding sphere.
    template <class BoundsOf>
    void gatherTransparent(const Vec3& eye, std::span<const gpu::DrawPiece> pieces, std::uint32_t first,
                           const BoundsOf& boundsOf);

    const StaticScene& scene_;
    const world::World& world_;
    const ResidentPieces& pieces_;
    Selection selection_;
    ZoneScreenRects rects_;
    DynamicPieces dynamicPieces_; ///< of the frame
    std::vector<TransparentRun> transparent_;
    std::vector<world::SkyPlacement> sky_;
    std::vector<std::pair<double, std::uint32_t>> lamps_; ///< squared distance from the eye, and number
};

} // namespace limen::frame
