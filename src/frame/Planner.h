#pragma once

#include "frame/FramePlan.h"
#include "frame/FrameView.h"
#include "frame/Highlights.h"
#include "frame/MoverPieces.h"
#include "frame/PlanBatches.h"
#include "frame/ResidentPieces.h"
#include "frame/Selection.h"
#include "frame/VisitRects.h"
#include "visibility/VisibleSet.h"
#include "world/DynamicState.h"
#include "world/World.h"

namespace limen::frame {

/// Turns what is visible into what is drawn. Holds memory for one world, so that a steady frame allocates
/// nothing; the world must outlive it and stay as it is.
class Planner {
public:
    explicit Planner(const world::World& world);
    Planner(const Planner&) = delete;
    Planner& operator=(const Planner&) = delete;

    /// Plans one frame; `plan` is overwritten. `set` must be the flood of the same world and moment from
    /// `frame.view`.
    void plan(const FrameView& frame, const world::DynamicState& dynamics, const visibility::VisibleSet& set,
              FramePlan& plan);
    /// The same where nothing moves.
    void plan(const FrameView& frame, const visibility::VisibleSet& set, FramePlan& plan) {
        this->plan(frame, {}, set, plan);
    }

    /// The resident pieces that its plans' runs are of: what SceneBuilder uploads.
    [[nodiscard]] const ResidentPieces& pieces() const { return pieces_; }

private:
    /// The blended pieces of one instance.
    struct TransparentRun {
        double distance = 0.0; ///< from the eye to the nearest point of its bounds, metres
        std::uint32_t instance = 0;
        PieceRun run;
    };

    void fillConstants(const FrameView& frame, const visibility::VisibleSet& set, FramePlan& plan) const;
    void fillCounts(const visibility::VisibleSet& set, FramePlan& plan) const;
    void planMovers(const FrameView& frame, const world::DynamicState& dynamics, FramePlan& plan);
    /// For what its record does not say.
    void changeMover(const FrameView& frame, const world::DynamicState& dynamics, std::uint32_t mover,
                     FramePlan& plan) const;
    void planSolid(bool several, FramePlan& plan);
    void addSolid(DrawClass drawn, bool several, FramePlan& plan);
    void planSky(const FrameView& frame, const visibility::VisibleSet& set, FramePlan& plan);
    void planTransparent(const Vec3& eye, bool several, const world::DynamicState& dynamics, FramePlan& plan);
    /// From pieces of one class, each instance's together. `first`: number of the first; `boundsOf(instance)`: its ball.
    template <class BoundsOf>
    void gatherTransparent(const Vec3& eye, std::span<const gpu::DrawPiece> pieces, std::uint32_t first,
                           const BoundsOf& boundsOf);

    const world::World& world_;
    const Clusters clusters_;
    const ResidentPieces pieces_;
    const Highlights highlights_;
    Selection selection_;
    VisitRects rects_;
    std::uint32_t staticMembers_ = 0; ///< zones that the scene lists for static instances
    MoverPieces moverPieces_;         ///< of the frame
    std::vector<TransparentRun> transparent_;
    std::vector<world::SkyPlacement> sky_;
};

} // namespace limen::frame
