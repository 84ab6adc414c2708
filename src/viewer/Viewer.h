#pragma once

#include "engine/stream/StreamedResidency.h"
#include "output/Probe.h"
#include "play/Play.h"
#include "viewer/Panel.h"
#include "viewer/ViewCheck.h"
#include "viewer/Window.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace limen::viewer {

/// The key bindings and their file.
struct ViewerKeys {
    KeyBindings bindings;
    std::filesystem::path file; ///< empty: no configuration directory
};

/// The window's frame loop: passes input to Play, Play's request to the session, the frame to the window.
class Viewer {
public:
    /// `screenshots`: the directory of saved screenshots.
    Viewer(Window& window, gpu::GlDevice& device, engine::Session& session, engine::FrameRequest start,
           ViewerKeys keys, std::filesystem::path screenshots);

    /// Queues an act for the next frame.
    void act(play::PlayAct act) { acts_.push_back(act); }

    /// Runs one frame. `fixedSeconds` > 0 replaces the measured time since the last frame.
    [[nodiscard]] Result<void> frame(double fixedSeconds);

    /// Waits for window events while the window is hidden. Draws nothing and stops the world's time.
    void rest();

    /// The visibility changes of the last frame as JSON lines; empty unless the probe is on.
    [[nodiscard]] const std::string& probed() const { return probed_; }
    [[nodiscard]] bool isLeaving() const { return leaving_ || window_.wantsToClose(); }
    [[nodiscard]] const engine::FrameRequest& request() const { return play_.request(); }
    [[nodiscard]] const play::PlayInput& input() const { return input_; }
    [[nodiscard]] engine::StreamedResidency& stream() { return stream_; }
    [[nodiscard]] const OverlaySwitches& switches() const { return switches_; }
    [[nodiscard]] const std::optional<engine::Picked>& picked() const { return picked_; }
    [[nodiscard]] const std::optional<ViewVerdict>& verdict() const { return verdict_; }
    [[nodiscard]] const play::WalkingBody& walk() const { return play_.walk(); }
    /// The destination that is loading; empty: none.
    [[nodiscard]] std::string_view goingTo() const { return play_.goingTo(); }
    /// The name of the door that the use key moves; empty: none.
    [[nodiscard]] std::string doorInReach() const;
    /// The notice shown over the picture; empty: none.
    [[nodiscard]] std::string noticeText() const;
    [[nodiscard]] const std::optional<Rebinding>& rebinding() const { return rebinding_; }
    [[nodiscard]] const KeyBindings& bindings() const { return bindings_; }
    [[nodiscard]] std::span<const PortalTrace> portals() const { return portals_; }
    [[nodiscard]] WindowSizes sizes() const { return window_.sizes(); }
    /// The number of visits of the frozen flood; 0 without one.
    [[nodiscard]] std::size_t frozenVisits() const { return frozen_ ? frozen_->visible.visits.size() : 0; }
    /// Names of the open doors in the loaded part.
    [[nodiscard]] std::vector<std::string> openDoors() const;

private:
    /// Performs the actions of pressed keys and buttons. During a rebinding the next key completes it
    /// instead.
    void takeKeys();

    void press(Action action);

    /// Completes the rebinding with a key and saves the bindings. Escape cancels.
    void rebind(KeyCode key);

    void keepBindings(KeyBindings bindings);

    /// Saves the frame without overlays, and the command that draws it again.
    Result<void> keepPicture();

    /// Shows a notice over the picture for a few seconds.
    void notice(std::string text);

    /// Toggles the frozen flood: keeps the last frame's flood for inspection.
    void freeze();

    /// The fates of portals in the last frame's flood.
    std::vector<PortalTrace> portalsNow();

    /// The landblocks around eye and player.
    [[nodiscard]] ResidencyMap residency() const;

    /// Builds the play input of this frame.
    const play::PlayInput& takeInput(double seconds);

    /// Selects the object at a pixel for the panel. The same object again, or the void, clears the selection.
    Result<void> pick(const PixelPlace& place);

    /// Toggles the check of this view against the ray rule. The verdict is shown until the view changes.
    Result<void> check();

    /// A pulsing yellow highlight of the picked object. Not for landscape, where an object is a whole block.
    [[nodiscard]] std::optional<frame::Highlight> selectionPulse() const;

    /// True until the eye leaves the start position.
    bool isAtStart();

    /// Queues the panel's choices for the next frame.
    void take(const PanelChoice& choice);

    /// Draws the overlay stage over the frame in the window.
    void overlay();

    Window& window_;
    gpu::GlDevice& device_;
    engine::Session& session_;
    Panel panel_;
    engine::StreamedResidency stream_;
    play::Play play_;
    play::PlayInput input_;
    std::vector<play::PlayAct> acts_; ///< of the next frame
    KeyBindings bindings_;
    std::filesystem::path keysFile_;
    std::optional<Rebinding> rebinding_; ///< set while waiting for a key
    struct Notice {
        std::string text;
        double until = 0.0; ///< as Window::seconds
    };
    Notice notice_;
    Vec3 start_{0.0}; ///< the eye's start position
    bool hasLeft_ = false;
    OverlaySwitches switches_;
    std::optional<engine::Picked> picked_;
    ViewCheck viewCheck_;
    bool wantsCheck_ = false, wantsPicture_ = false;
    std::filesystem::path screenshots_; ///< directory of screenshots
    std::optional<output::Probe> probe_;
    std::string probed_;
    std::optional<ViewVerdict> verdict_; ///< of the view checkedFrom_
    engine::FrameRequest checkedFrom_;
    std::optional<FrozenFlood> frozen_;
    visibility::FloodTrace trace_;
    std::vector<PortalTrace> portals_; ///< as shown in this frame
    double lastSeconds_ = 0.0;
    double frameSeconds_ = 0.0; ///< since the last frame
    FrameWindows times_;
    std::uint64_t frames_ = 0;
    bool leaving_ = false;
};

} // namespace limen::viewer
