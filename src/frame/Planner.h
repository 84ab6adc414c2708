#pragma once

#include "frame/FramePlan.h"
#include "frame/FrameView.h"
#include "visibility/Viewcone.h"
#include "visibility/VisibleSet.h"
#include "world/Moment.h"
#include "world/World.h"

namespace limen::frame {

/// Turns what is visible into what is drawn. Holds memory for one world, so that a steady frame allocates
/// nothing; the world must outlive it and stay as it is.
class Planner {
public:
    explicit Planner(const world::World& world);

    /// Plans one frame; `plan` is overwritten. `set` must be the flood of the same world and moment from
    /// `frame.view`.
    void plan(const FrameView& frame, const world::Moment& moment, const visibility::VisibleSet& set,
              FramePlan& plan);
    /// The same where nothing moves.
    void plan(const FrameView& frame, const visibility::VisibleSet& set, FramePlan& plan) {
        this->plan(frame, {}, set, plan);
    }

private:
    struct Mark {
        std::uint32_t frame = 0; ///< the last frame that met the instance
        visibility::Containment seen = visibility::Containment::Outside;
        bool tested = false; ///< in some visit
    };
    /// One instance of this frame's draw list.
    struct Drawn {
        double distance = 0.0; ///< from the eye to the nearest point of its bounds, metres
        std::uint32_t instance = 0;
        bool gated = false;
    };

    void fillConstants(const FrameView& frame, const visibility::VisibleSet& set, FramePlan& plan) const;
    void packMovers(FramePlan& plan);
    /// Static instances, and on from there the moment's.
    [[nodiscard]] const world::Instance& instance(std::uint32_t index) const {
        return index < world_.instances.size() ? world_.instances[index]
                                               : moment_->instances[index - world_.instances.size()];
    }
    void collect(const FrameView& frame, const visibility::VisibleSet& set, FramePlan& plan);
    void meet(const FrameView& frame, const visibility::SeenSpace& seen, world::InstanceIndex index,
              FramePlan& plan);
    void finishDrawn(const FrameView& frame, const visibility::VisibleSet& set, FramePlan& plan);
    void planSolid(bool several, FramePlan& plan) const;
    void planSky(const FrameView& frame, const visibility::VisibleSet& set, FramePlan& plan);
    void planLate(bool several, FramePlan& plan) const;
    void addBatch(FramePlan& plan, Program program, bool gated, world::SurfaceClass surfaces,
                  bool terrain) const;
    void addCommand(FramePlan& plan, std::uint32_t index, world::SurfaceClass surfaces) const;

    const world::World& world_;
    const world::Moment* moment_ = nullptr; ///< of the frame being planned
    std::uint32_t staticMembers_ = 0;       ///< zones that the scene lists for static instances
    std::vector<std::uint8_t> singleZone_;  ///< by instance: a member of one zone only
    std::vector<Mark> marks_;               ///< by instance
    std::vector<std::uint32_t> met_;
    std::vector<Drawn> drawn_;
    std::vector<world::SkyPlacement> sky_;
    visibility::Viewcones cones_;
    std::uint32_t frameNumber_ = 0;
};

} // namespace limen::frame
