#pragma once

#include "engine/Session.h"
#include "viewer/scale/FrameScale.h"
#include "viewer/scale/ScaleWish.h"

namespace limen::viewer {

/// The scale as panel, page and state show it.
struct ScaleFacts {
    ScaleWish wish;
    std::uint32_t percent = kFullScale; ///< of the last frame
    double frameRate = kSoftwareRate;   ///< in effect
    double automaticRate = kSoftwareRate;
    double sceneMs = 0.0; ///< 3-D work of the last frame, milliseconds; NaN: not measured
};

/// The conditions of one frame.
struct ScaleInput {
    ScaleWish wish;
    bool isSoftware = false; ///< the driver has no graphics card
    double displayRate = 60.0;
    std::optional<std::size_t> quality; ///< of kQualities; bounds the automatic scale
    double frameMs = 0.0;               ///< from the start of the last frame to now
    bool isHeld = false;                ///< the automatic scale stays: the picture stands still
};

/// The scale of the 3-D picture in the window: chosen by the user, else by FrameScale.
class PictureScale {
public:
    /// Chooses the scale of the next frame.
    [[nodiscard]] std::uint32_t choose(const ScaleInput& input);
    /// Takes the 3-D work of the frame that was drawn just now, milliseconds; NaN: not measured. A frame without this
    /// call drew nothing.
    void note(double sceneMs);
    [[nodiscard]] const ScaleFacts& facts() const { return facts_; }

private:
    FrameScale scale_;
    ScaleFacts facts_;
    std::optional<double> lastMs_; ///< of the last frame, until the next
};

/// Draws a frame and yields its 3-D work in milliseconds. Without a graphics card: from the call to the last pixel. With
/// one: the GPU time of the latest frame with timer results; NaN: none yet. Errors: Session::draw's.
[[nodiscard]] Result<double> drawTimed(engine::Session& session, const engine::FrameRequest& request,
                                       const engine::DrawOptions& options);

} // namespace limen::viewer
