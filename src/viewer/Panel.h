#pragma once

#include "engine/FrameReport.h"
#include "engine/Picked.h"
#include "engine/Quality.h"
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

/// What the overlay stage shows, switched by keys.
struct OverlaySwitches {
    bool help = false, ids = false, depth = false, regions = false, portals = false, panel = true;
};

/// Milliseconds, over the last five seconds.
struct StageWindows {
    TimeWindow cpu, gpu;
};
struct FrameWindows {
    TimeWindow frame;                 ///< from one to the next
    std::vector<StageWindows> stages; ///< as FrameFigures::stages

    void add(double now, double frameMs, const engine::FrameFigures& figures);
};

/// A key is to be bound: alone, or besides those that do the same.
struct Rebinding {
    Action action = Action::Forward;
    bool adds = false;
    friend bool operator==(const Rebinding&, const Rebinding&) = default;
};

/// What the panel tells of a frame.
struct PanelFacts {
    const world::World& world;
    const engine::FrameRequest& request;
    const visibility::VisibleSet& visible;
    const frame::FramePlan& plan;
    engine::FrameFigures figures;
    const FrameWindows& times;
    const motion::BodyState* body; ///< null: the eye flies
    const world::Door* door;       ///< in reach of it; null: none
    bool doorOpens;                ///< it stands open, or is opening
    const engine::Picked* picked;  ///< null: nothing is
    const ViewVerdict* verdict;    ///< on this very view; null: none
    const FrozenFlood* frozen;     ///< to be shown in the picture; null: none
    std::span<const PortalTrace>
        portals; ///< of this flood, or the one that is kept; only when they are to be shown
    const ResidencyMap& residency;
    std::optional<std::size_t> quality; ///< of kQualities
    std::span<const world::Place> places;
    std::span<const std::uint32_t> ids; ///< the id image, only when it is to be shown
    std::span<const float> distances;   ///< likewise: RenderTarget::readDistances
    const KeyBindings& bindings;
    const std::optional<Rebinding>& rebinding; ///< what the next key will do
    std::string_view notice;                   ///< empty: there is nothing to say
    bool greets = false;                       ///< the greeting is shown
};

/// What was chosen in the panel: as it was, where nothing was.
struct PanelChoice {
    int place = -1; ///< that was clicked; -1: none
    double time = 0.5;
    std::uint32_t dayGroup = 0;
    engine::Weather weather = engine::Weather::Clear;
    std::optional<double> doors;        ///< as in FrameRequest
    std::optional<Rebinding> rebinding; ///< the next key is to be that
    bool keysAsAtFirst = false;
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

    /// The mouse while it is over the panel, keys while a number is typed into it.
    [[nodiscard]] Taken takes() const;
    /// Draws into the bound framebuffer.
    PanelChoice draw(const PanelFacts& facts, const OverlaySwitches& switches);

private:
    /// Letters and boxes as large as the window's screen wants them.
    void fitScale();
    /// Over the whole window; `opacity` 0..255.
    void drawOver(const output::Picture& picture, int opacity);
    struct OverTexture;
    std::unique_ptr<OverTexture> over_;
    const Window& window_;
    UiScale scale_;
};

} // namespace limen::viewer
