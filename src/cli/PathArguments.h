#pragma once

#include "play/FrameSource.h"

#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
}

// The frames of `tour`, `probe`, `check` and `walk`: a camera on a path, or a recorded walk.
namespace limen::cli {

/// The options as typed; empty: not given.
struct PathArguments {
    std::string path, walk, size, fov = "60", time = "0.5", frames, fps;
};
/// Adds these options. `frames`: the default number of frames, for the help text.
void addPathOptions(CLI::App& command, PathArguments& arguments, std::size_t frames);

/// `frames`: the default number. Errors: an option that is no number, or out of its bounds.
[[nodiscard]] Result<play::PathRequest> checkPath(const PathArguments& arguments, std::size_t frames);

/// The way points: from a file in the form of `shot`'s views files, or the world's own tour; places resolved. Errors: the file's;
/// the world has no tour.
[[nodiscard]] Result<std::vector<engine::ViewRequest>> wayPointsOf(const PathArguments& arguments,
                                                                   const world::WorldFile& file);

/// The first frame of a recorded walk. Errors: its line makes no sense.
[[nodiscard]] Result<engine::ViewRequest> walkStart(const play::WalkRecord& walk);

/// Checks as much as is possible without a session. Errors: checkPath's, wayPointsOf's, readWalk's.
[[nodiscard]] Result<play::FramesRequest> checkFrames(const PathArguments& arguments, std::size_t frames,
                                                      const world::WorldFile& file);

} // namespace limen::cli
