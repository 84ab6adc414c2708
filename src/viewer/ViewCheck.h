#pragma once

#include "check/Traced.h"
#include "engine/Session.h"
#include "output/CheckPicture.h"

#include <optional>

namespace limen::viewer {

/// One view held against the ray rule, as `limen check` judges.
struct ViewVerdict {
    check::Comparison comparison;
    output::Picture picture; ///< pictureOfVerdicts
    double seconds = 0.0;    ///< it took
};

/// Checks single views of what a session has loaded. Keeps the world as the rays see it, which takes a second to make, until
/// another is loaded.
class ViewCheck {
public:
    /// Draws a frame of ids and layers: draw the one to show again. Requires a loaded world. Errors: those of drawing.
    [[nodiscard]] Result<ViewVerdict> check(engine::Session& session, const engine::FrameRequest& request);

private:
    std::shared_ptr<const engine::LoadedPart> world_; ///< that traced_ is of
    std::optional<check::TracedWorld> traced_;
};

} // namespace limen::viewer
