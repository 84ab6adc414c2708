#pragma once

#include "play/Play.h"
#include "play/WalkRecord.h"

#include <functional>
#include <string>
#include <vector>

namespace limen::play {

/// How the body moves from way point to way point.
struct FootWalkOptions {
    double fps = 30.0; ///< frames a second of walking
    bool chase = false, run = false;
};

struct FootWalk {
    WalkRecord record;
    std::vector<std::size_t> missed; ///< indices of way points that the body did not reach
    std::vector<std::string> jumps;  ///< names of places that the body jumped to, for lack of a way on foot
};

/// Walks straight between way points, opens doors, and goes around obstacles. A blocked body tries the next way
/// points, then jumps to the first named place at a later one, or the walk ends. `done` receives the number of
/// finished way points.
/// The session should draw nothing (gpu::NullDevice). Errors: the session's.
[[nodiscard]] Result<FootWalk> walkOnFoot(engine::Session& session, const engine::FrameRequest& start,
                                          const std::vector<engine::ViewRequest>& points,
                                          const FootWalkOptions& options,
                                          const std::function<void(std::size_t)>& done = {});

} // namespace limen::play
