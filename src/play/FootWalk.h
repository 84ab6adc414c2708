#pragma once

#include "play/Play.h"
#include "play/WalkRecord.h"

#include <functional>
#include <string>
#include <vector>

namespace limen::play {

/// How somebody goes from way point to way point.
struct FootWalkOptions {
    double fps = 30.0; ///< frames a second of walking
    bool chase = false, run = false;
};

struct FootWalk {
    WalkRecord record;
    std::vector<std::size_t> missed; ///< way points that could not be walked to
    std::vector<std::string> jumps;  ///< places that were gone to where no way leads on foot
};

/// Walks from way point to way point: straight towards each, opening doors that are in the way. Where it gets no farther it
/// tries the next ones, and then goes to the first of the world's places that lies at a later way point, and on from there; where there is
/// none, the walk ends. The session
/// should draw nothing (gpu::NullDevice). `done` is told of way points. Errors: the session's.
[[nodiscard]] Result<FootWalk> walkOnFoot(engine::Session& session, const engine::FrameRequest& start,
                                          const std::vector<engine::ViewRequest>& points,
                                          const FootWalkOptions& options,
                                          const std::function<void(std::size_t)>& done = {});

} // namespace limen::play
