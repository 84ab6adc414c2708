#pragma once

#include "check/Traced.h"
#include "engine/Session.h"
#include "output/CheckPicture.h"

#include <optional>

namespace limen::viewer {

/// The comparison of one view with the ray rule, by the criteria of `limen check`.
struct ViewVerdict {
    check::Comparison comparison;
    output::Picture picture; ///< pictureOfVerdicts
    double seconds = 0.0;    ///< duration of the check
};

/// Checks single views of a session's loaded world. Caches the reference's form of the world, which takes
/// about a second to build, until the session shows another part.
class ViewCheck {
public:
    /// Draws a frame of ids and layers, so the caller must redraw the frame to show. Requires a loaded world.
    /// Errors: those of drawing.
    [[nodiscard]] Result<ViewVerdict> check(engine::Session& session, const engine::FrameRequest& request);

private:
    std::shared_ptr<const engine::LoadedPart> world_; ///< the part of traced_
    std::optional<check::TracedWorld> traced_;
};

} // namespace limen::viewer
