#pragma once

#include "engine/Quality.h"
#include "engine/report/FrameReport.h"
#include "engine/report/Picked.h"
#include "motion/Body.h"
#include "viewer/KeyBindings.h"
#include "viewer/inspect/FrozenFlood.h"
#include "viewer/inspect/NameTags.h"
#include "viewer/inspect/PortalTraces.h"
#include "viewer/inspect/ResidencyMap.h"
#include "viewer/inspect/TimeWindow.h"
#include "viewer/inspect/ViewCheck.h"
#include "viewer/scale/PictureScale.h"
#include "world/Places.h"

#include <span>

namespace limen::viewer {

/// The parts of the overlay stage, toggled by keys.
struct OverlaySwitches {
    bool ids = false, depth = false, regions = false, portals = false, names = false, panel = false;
};

/// Times in milliseconds over the last five seconds.
struct StageWindows {
    TimeWindow cpu, gpu;
};
struct FrameWindows {
    TimeWindow frame;                 ///< from one frame to the next
    TimeWindow scene;                 ///< 3-D work (drawTimed)
    std::vector<StageWindows> stages; ///< as FrameFigures::stages

    void add(double now, double frameMs, double sceneMs, const engine::FrameFigures& figures);
};

/// The input of the panel and of the drawings over the picture, for one frame.
struct PanelFacts {
    const world::World& world;
    const engine::FrameRequest& request;
    const visibility::VisibleSet& visible;
    const frame::FramePlan& plan;
    engine::FrameFigures figures;
    const FrameWindows& times;
    const motion::BodyState* body;        ///< null: the eye flies
    const world::Door* door;              ///< the door in reach; null: none
    bool doorOpens;                       ///< the door is open or opening
    bool isRefused;                       ///< it was just used, and stays shut because it is locked
    const engine::Picked* picked;         ///< the inspected object; null: none
    const ViewVerdict* verdict;           ///< the check of exactly this view; null: none
    const FrozenFlood* frozen;            ///< the frozen flood, drawn over the picture; null: none
    std::span<const PortalTrace> portals; ///< of the current or frozen flood; empty unless shown
    std::span<const NameTag> names;       ///< of this frame; empty unless shown
    const ResidencyMap& residency;
    std::optional<std::size_t> quality; ///< of kQualities
    const ScaleFacts& scale;
    std::span<const world::Place> places;
    std::span<const std::uint32_t> ids; ///< the id image; empty unless shown
    std::span<const float> distances;   ///< RenderTarget::readDistances; empty unless shown
    const KeyBindings& bindings;
};

/// The user's choices in the panel; controls that were not touched keep the current values.
struct PanelChoice {
    int place = -1; ///< index of the clicked place; -1: none
    double time = 0.5;
    std::uint32_t dayGroup = 0;
    engine::Weather weather = engine::Weather::Clear;
    std::optional<double> doors;        ///< as in FrameRequest
    std::optional<std::size_t> quality; ///< of kQualities
    frame::Gate gate = frame::Gate::Ownership;
    ScaleWish scale;
};

} // namespace limen::viewer
