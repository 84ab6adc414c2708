#pragma once

#include "play/CameraPath.h"
#include "play/RootTracker.h"
#include "engine/Session.h"
#include "cli/ShotRequest.h"

#include <string>
#include <vector>

// A camera that goes along a path.
namespace limen::play {

/// What the command line says of it.
struct PathArguments {
    std::string path, walk, size, fov = "60", time = "0.5", frames, fps;
};
/// Adds the options of these. `frames`: how many there are unless said; told to the user.
void addPathOptions(CLI::App& command, PathArguments& arguments, std::size_t frames);

/// The same, checked.
struct PathRequest {
    static constexpr std::size_t kMostFrames = 100'000;
    cli::PixelSize size;
    double fov = 60.0, time = 0.5, fps = 0.0;
    std::size_t frames = 0; ///< unless fps > 0

    [[nodiscard]] std::size_t countOn(const CameraPath& path) const;
    [[nodiscard]] double timeOf(const CameraPath& path, std::size_t frame) const;
};
/// `frames`: unless said. Errors: an option that is no number, or out of its bounds.
[[nodiscard]] Result<PathRequest> checkPath(const PathArguments& arguments, std::size_t frames);

/// The way points: of a file in the form of `shot`'s views files, or the world's own tour. Errors: of the file; there is no tour.
[[nodiscard]] Result<std::vector<engine::Viewpoint>> wayPointsOf(const PathArguments& arguments,
                                                         const world::WorldFile& file);

/// A path, and the eye at its beginning.
struct PathStart {
    CameraPath path;
    engine::FrameEye eye;
};
/// Loads what is around the first way point. Errors: the session's; a way point that is nowhere.
[[nodiscard]] Result<PathStart> startPath(engine::Session& session, const std::vector<engine::Viewpoint>& points,
                                          const PathRequest& request);

/// The camera on its way: where it is, and the space it was swept into. A path that leads through a wall is followed
/// all the same (RootTracker).
class PathWalk {
public:
    PathWalk(engine::Session& session, const CameraPath& path, engine::FrameEye start)
        : session_(session), path_(path), eye_(std::move(start)), tracker_(eye_.root) {}

    /// Moves to a later time on the path, through every corner on the way; loads what comes near.
    const engine::FrameEye& moveTo(double time);

private:
    engine::Session& session_;
    const CameraPath& path_;
    engine::FrameEye eye_;
    RootTracker tracker_;
    double time_ = 0.0;
    std::vector<Vec3> corners_;
};

} // namespace limen::play
