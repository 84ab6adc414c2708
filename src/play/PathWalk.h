#pragma once

#include "engine/Session.h"
#include "play/CameraPath.h"
#include "play/RootTracker.h"

#include <string>
#include <vector>

// A camera that moves along a path.
namespace limen::play {

/// A camera path and the frames along it.
struct PathRequest {
    static constexpr std::size_t kMostFrames = 100'000;
    engine::PixelSize size;
    double fov = 60.0, time = 0.5, fps = 0.0;
    std::size_t frames = 0; ///< ignored if fps > 0

    [[nodiscard]] std::size_t countOn(const CameraPath& path) const;
    [[nodiscard]] double timeOf(const CameraPath& path, std::size_t frame) const;
};
/// A path, and the request of its first frame.
struct PathStart {
    CameraPath path;
    engine::FrameRequest frame;
};
/// Loads the blocks around the first way point. Errors: the session's; an unresolved way point.
[[nodiscard]] Result<PathStart> startPath(engine::Session& session,
                                          const std::vector<engine::ViewRequest>& points,
                                          const PathRequest& request);

/// The camera on a path, with the space that a sweep through portals leads to. A path through a wall is
/// followed as well (RootTracker).
class PathWalk {
public:
    PathWalk(engine::Session& session, const CameraPath& path, engine::FrameRequest start)
        : session_(session), path_(path), frame_(std::move(start)), tracker_(frame_.root) {}

    /// Moves to a later time on the path, through every corner in between. Loads the blocks that come near.
    const engine::FrameRequest& moveTo(double time);

private:
    /// Puts the camera at a point that no line leads to, and loads the blocks around it.
    void jumpTo(const CameraPath::Corner& corner);

    engine::Session& session_;
    const CameraPath& path_;
    engine::FrameRequest frame_;
    RootTracker tracker_;
    double time_ = 0.0;
    std::vector<CameraPath::Corner> corners_;
};

} // namespace limen::play
