#pragma once

#include "engine/StreamedResidency.h"
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

/// Which keys do what, and the file that says so.
struct ViewerKeys {
    KeyBindings bindings;
    std::filesystem::path file; ///< empty: there is no place for one
};

/// The window's frame loop: hands to play, its eye to the frame, the frame to the window.
class Viewer {
public:
    /// Pictures are kept in `screenshots`.
    Viewer(Window& window, gpu::GlDevice& device, engine::Session& session, engine::FrameRequest start,
           ViewerKeys keys, std::filesystem::path screenshots);

    /// What is to be done at the beginning of the next frame.
    void act(play::PlayAct act) { acts_.push_back(act); }

    /// One frame; `fixedSeconds` > 0 takes that for the time since the last one.
    [[nodiscard]] Result<void> frame(double fixedSeconds);

    /// Nobody sees the window: nothing is drawn and no time passes until something happens to it.
    void rest();

    /// What changed with the last frame in what was decided, if that is to be told.
    [[nodiscard]] const std::string& probed() const { return probed_; }
    [[nodiscard]] bool isLeaving() const { return leaving_ || window_.wantsToClose(); }
    [[nodiscard]] const engine::FrameRequest& request() const { return play_.request(); }
    [[nodiscard]] const play::PlayInput& input() const { return input_; }
    [[nodiscard]] engine::StreamedResidency& stream() { return stream_; }
    [[nodiscard]] const OverlaySwitches& switches() const { return switches_; }
    [[nodiscard]] const std::optional<engine::Picked>& picked() const { return picked_; }
    [[nodiscard]] const std::optional<ViewVerdict>& verdict() const { return verdict_; }
    [[nodiscard]] const play::WalkingBody& walk() const { return play_.walk(); }
    /// As Play::goingTo.
    [[nodiscard]] std::string_view goingTo() const { return play_.goingTo(); }
    /// The name of the door that a key would open or shut; empty: none.
    [[nodiscard]] std::string doorInReach() const;
    /// What is said over the picture just now.
    [[nodiscard]] std::string noticeText() const;
    [[nodiscard]] const std::optional<Rebinding>& rebinding() const { return rebinding_; }
    [[nodiscard]] const KeyBindings& bindings() const { return bindings_; }
    [[nodiscard]] std::span<const PortalTrace> portals() const { return portals_; }
    [[nodiscard]] WindowSizes sizes() const { return window_.sizes(); }
    /// Of the flood that is kept; none is: 0.
    [[nodiscard]] std::size_t frozenVisits() const { return frozen_ ? frozen_->visible.visits.size() : 0; }
    /// Names of doors that stand open, as far as they are loaded.
    [[nodiscard]] std::vector<std::string> openDoors() const;

private:
    /// What keys and buttons ask for; while a key is waited for, the next one is that.
    void takeKeys();

    void press(Action action);

    /// The key that was waited for does that from now on, in the file as well. Escape: nothing changes.
    void rebind(KeyCode key);

    void keepBindings(KeyBindings bindings);

    /// The frame without what lies over it, in a file, and what draws it again.
    Result<void> keepPicture();

    /// Says something over the picture for a while.
    void notice(std::string text);

    /// The last frame's flood is kept, to be flown around; once more: no longer.
    void freeze();

    /// What becomes of portals in the last frame's flood.
    std::vector<PortalTrace> portalsNow();

    /// The landblocks around eye and player.
    [[nodiscard]] ResidencyMap residency() const;

    /// What hands ask of this frame.
    const play::PlayInput& takeInput(double seconds);

    /// What is there is told in the panel; the same thing again, or the void: nothing is any more.
    Result<void> pick(const PixelPlace& place);

    /// Holds what is seen against the ray rule and shows what that says, until that changes; once more: no longer.
    Result<void> check();

    /// The picked object comes and goes in yellow. Not the landscape: one object is a block of it, and half the window.
    [[nodiscard]] std::optional<frame::Highlight> selectionPulse() const;

    /// Nobody has moved from where the window opened.
    bool isAtStart();

    /// What was chosen in the panel is done in the next frame.
    void take(const PanelChoice& choice);

    /// The overlay stage, over the frame in the window.
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
    std::optional<Rebinding> rebinding_; ///< a key is waited for
    struct Notice {
        std::string text;
        double until = 0.0; ///< as Window::seconds
    };
    Notice notice_;
    Vec3 start_{0.0}; ///< where the eye was at first
    bool hasLeft_ = false;
    OverlaySwitches switches_;
    std::optional<engine::Picked> picked_;
    ViewCheck viewCheck_;
    bool wantsCheck_ = false, wantsPicture_ = false;
    std::filesystem::path screenshots_; ///< the directory for pictures
    std::optional<output::Probe> probe_;
    std::string probed_;
    std::optional<ViewVerdict> verdict_; ///< on the view from checkedFrom_
    engine::FrameRequest checkedFrom_;
    std::optional<FrozenFlood> frozen_;
    visibility::FloodTrace trace_;
    std::vector<PortalTrace> portals_; ///< that are shown
    double lastSeconds_ = 0.0;
    double frameSeconds_ = 0.0; ///< since the last frame
    FrameWindows times_;
    std::uint64_t frames_ = 0;
    bool leaving_ = false;
};

} // namespace limen::viewer
