#pragma once

#include "engine/stream/StreamedResidency.h"
#include "output/Probe.h"
#include "play/Play.h"
#include "viewer/HeldInput.h"
#include "viewer/Overlay.h"
#include "viewer/inspect/ViewCheck.h"
#include "viewer/open/WorldOpening.h"
#include "viewer/pages/Ui.h"
#include "viewer/panel/PanelFacts.h"
#include "viewer/scale/PictureScale.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace limen::viewer {

/// The window's input to a world for one frame.
struct WorldInput {
    HeldInput held;
    engine::PixelSize size;            ///< of the window
    std::uint32_t percent = 100;       ///< of the window's pixels each way that are drawn
    std::optional<PixelPlace> clicked; ///< inspects the object there
    double seconds = 0.0;              ///< of the world, since the last frame
    double now = 0.0;                  ///< as Window::seconds
    double frameSeconds = 0.0;         ///< measured since the last frame
    bool isPaused = false;             ///< a page covers the world
};

/// One open world: passes input to Play, Play's request to the session, and draws panel and outlines over the
/// frame.
class WorldView {
public:
    /// The device must outlive it.
    WorldView(gpu::GlDevice& device, OpenedWorld opened);

    /// Queues an act for the next frame.
    void act(play::PlayAct act) { acts_.push_back(act); }
    /// Carries out an action of the world. False: the action belongs to the window.
    bool press(Action action);

    /// Draws one frame into the session's target. A paused world is not drawn again while nothing changes.
    [[nodiscard]] Result<void> frame(const WorldInput& input);
    /// Whether the last `frame` made a step that a recorded walk needs.
    [[nodiscard]] bool hasStepped() const { return hasStepped_; }
    /// Copies the drawn frame to the window.
    void present();
    /// Draws outlines, door hint and panel over the frame, and takes the panel's choices. Yields a choice of scale, which
    /// belongs to the window.
    std::optional<ScaleWish> drawOverlay(Ui& ui, Overlay& overlay, const KeyBindings& bindings,
                                         const ScaleFacts& scale);

    /// Saves the frame without overlays, and the command that draws it again. Returns the absolute path.
    [[nodiscard]] Result<std::filesystem::path> keepPicture(const std::filesystem::path& directory);

    /// The command line that draws a frame of this world again.
    [[nodiscard]] std::string commandOf(const engine::FrameRequest& request) const;

    /// The visibility changes of the last frame as JSON lines; empty unless the probe is on.
    [[nodiscard]] const std::string& probed() const { return probed_; }
    /// The view in the window's size.
    [[nodiscard]] const engine::FrameRequest& request() const { return play_.request(); }
    /// The same view in the size in which it was drawn.
    [[nodiscard]] const engine::FrameRequest& drawn() const { return drawn_; }
    /// As drawTimed, of the last frame.
    [[nodiscard]] double sceneMs() const { return sceneMs_; }
    [[nodiscard]] const FrameWindows& times() const { return times_; }
    [[nodiscard]] const play::PlayInput& input() const { return input_; }
    [[nodiscard]] engine::Session& session() { return *session_; }
    [[nodiscard]] const engine::Session& session() const { return *session_; }
    [[nodiscard]] engine::StreamedResidency& stream() { return stream_; }
    [[nodiscard]] const OverlaySwitches& switches() const { return switches_; }
    /// Names over the picture; empty unless shown.
    [[nodiscard]] const std::vector<NameTag>& names() const { return names_; }
    [[nodiscard]] const std::optional<engine::Picked>& picked() const { return picked_; }
    [[nodiscard]] const std::optional<ViewVerdict>& verdict() const { return verdict_; }
    [[nodiscard]] const play::WalkingBody& walk() const { return play_.walk(); }
    /// The destination that is loading; empty: none.
    [[nodiscard]] std::string_view goingTo() const { return play_.goingTo(); }
    /// The name of the door that the use key moves; empty: none.
    [[nodiscard]] std::string doorInReach() const;
    /// Whether that door was just used and is locked.
    [[nodiscard]] bool isRefused() const { return play_.isRefused(); }
    [[nodiscard]] std::span<const PortalTrace> portals() const { return portals_; }
    /// The number of visits of the frozen flood; 0 without one.
    [[nodiscard]] std::size_t frozenVisits() const { return frozen_ ? frozen_->visible.visits.size() : 0; }
    /// Names of the open doors in the loaded part.
    [[nodiscard]] std::vector<std::string> openDoors() const;

private:
    /// Toggles the frozen flood: keeps the last frame's flood for inspection.
    void freeze();
    /// The fates of portals in the last frame's flood.
    std::vector<PortalTrace> portalsNow();
    /// The landblocks around eye and player.
    [[nodiscard]] ResidencyMap residency() const;
    [[nodiscard]] bool needsFrame(const WorldInput& input) const;
    /// Builds the play input of this frame.
    const play::PlayInput& takeInput(const WorldInput& input);
    /// Selects the object at a pixel for the panel. The same object again, or the void, clears the selection.
    Result<void> pick(const PixelPlace& place);
    /// Toggles the check of this view against the ray rule. The verdict is shown until the view changes.
    Result<void> check();
    /// Draws `drawn_` and measures it.
    Result<void> draw();
    /// A pulsing yellow highlight of the picked object. Not for landscape, where an object is a whole block.
    [[nodiscard]] std::optional<frame::Highlight> selectionPulse() const;
    void drawImages(Overlay& overlay, const PanelFacts& facts) const;
    /// Queues the panel's choices for the next frame.
    void take(const PanelChoice& choice);

    gpu::GlDevice& device_;
    std::unique_ptr<engine::Session> session_;
    engine::StreamedResidency stream_;
    play::Play play_;
    play::PlayInput input_;
    engine::FrameRequest drawn_;
    std::uint32_t percent_ = 100;
    double sceneMs_ = 0.0;
    std::vector<play::PlayAct> acts_; ///< of the next frame
    OverlaySwitches switches_;
    std::vector<NameTag> names_; ///< as shown in this frame
    std::optional<engine::Picked> picked_;
    ViewCheck viewCheck_;
    bool wantsCheck_ = false, hasStepped_ = false;
    std::optional<output::Probe> probe_;
    std::string probed_;
    std::optional<ViewVerdict> verdict_; ///< of the view checkedFrom_
    engine::FrameRequest checkedFrom_;
    std::optional<FrozenFlood> frozen_;
    visibility::FloodTrace trace_;
    std::vector<PortalTrace> portals_; ///< as shown in this frame
    std::vector<std::uint32_t> ids_;   ///< of this frame; empty unless shown
    std::vector<float> distances_;
    FrameWindows times_;
    std::uint64_t frames_ = 0;
};

} // namespace limen::viewer
