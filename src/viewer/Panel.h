#pragma once

#include "engine/Quality.h"
#include "engine/report/FrameReport.h"
#include "engine/report/Picked.h"
#include "motion/Body.h"
#include "viewer/FrozenFlood.h"
#include "viewer/PortalTraces.h"
#include "viewer/ResidencyMap.h"
#include "viewer/TimeWindow.h"
#include "viewer/ViewCheck.h"
#include "viewer/Window.h"
#include "world/Places.h"

#include <memory>
#include <span>

namespace limen::viewer {

/// The parts of the overlay stage, toggled by keys.
struct OverlaySwitches {
    bool help = false, ids = false, depth = false, regions = false, portals = false, panel = true;
};

/// Times in milliseconds over the last five seconds.
struct StageWindows {
    TimeWindow cpu, gpu;
};
struct FrameWindows {
    TimeWindow frame;                 ///< from one frame to the next
    std::vector<StageWindows> stages; ///< as FrameFigures::stages

    void add(double now, double frameMs, const engine::FrameFigures& figures);
};

/// A pending key binding: the next key replaces the keys of the action, or is added to them.
struct Rebinding {
    Action action = Action::Forward;
    bool adds = false;
    friend bool operator==(const Rebinding&, const Rebinding&) = default;
};

/// The panel's input for one frame.
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
    const engine::Picked* picked;         ///< the inspected object; null: none
    const ViewVerdict* verdict;           ///< the check of exactly this view; null: none
    const FrozenFlood* frozen;            ///< the frozen flood, drawn over the picture; null: none
    std::span<const PortalTrace> portals; ///< of the current or frozen flood; empty unless shown
    const ResidencyMap& residency;
    std::optional<std::size_t> quality; ///< of kQualities
    std::span<const world::Place> places;
    std::span<const std::uint32_t> ids; ///< the id image; empty unless shown
    std::span<const float> distances;   ///< RenderTarget::readDistances; empty unless shown
    const KeyBindings& bindings;
    const std::optional<Rebinding>& rebinding; ///< the binding that the next key completes
    std::string_view notice;                   ///< empty: none
    bool greets = false;                       ///< show the greeting
};

/// The user's choices in the panel; controls that were not touched keep the current values.
struct PanelChoice {
    int place = -1; ///< index of the clicked place; -1: none
    double time = 0.5;
    std::uint32_t dayGroup = 0;
    engine::Weather weather = engine::Weather::Clear;
    std::optional<double> doors;        ///< as in FrameRequest
    std::optional<Rebinding> rebinding; ///< a binding to start
    bool resetsKeys = false;            ///< restore the default keys
    std::optional<std::size_t> quality; ///< of kQualities
};

/// The overlay stage of the window: panel, help, places, outlines. Owns the Dear ImGui context and its GL
/// objects.
class Panel {
public:
    /// The window must outlive it.
    explicit Panel(const Window& window);
    ~Panel();
    Panel(const Panel&) = delete;
    Panel& operator=(const Panel&) = delete;

    /// The input that the panel uses: the mouse while it is over the panel, keys while a number is typed.
    [[nodiscard]] Taken takes() const;
    /// Draws into the bound framebuffer.
    PanelChoice draw(const PanelFacts& facts, const OverlaySwitches& switches);

private:
    /// Scales fonts and boxes to the content scale of the window's screen.
    void fitScale();
    /// Draws a picture over the whole window; `opacity` 0..255.
    void drawOver(const output::Picture& picture, int opacity);
    struct OverTexture;
    std::unique_ptr<OverTexture> over_;
    const Window& window_;
    UiScale scale_;
};

} // namespace limen::viewer
