#pragma once

#include "cli/Console.h"
#include "engine/WorldSource.h"
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

/// `frames` is the default number. Errors: an option that is not a number or is out of bounds.
[[nodiscard]] Result<play::PathRequest> checkPath(const PathArguments& arguments, std::size_t frames);

/// The way points, with places resolved: from a file in the format of `shot`'s views files, or from the
/// world's tour (engine::tourOf). Errors: the file's; tourOf's; NotFound without a tour.
[[nodiscard]] Result<std::vector<engine::ViewRequest>>
wayPointsOf(const PathArguments& arguments, const engine::WorldSource& source, const Console& console);

/// The first view of a recorded walk. Errors: a malformed start line.
[[nodiscard]] Result<engine::ViewRequest> walkStart(const play::WalkRecord& walk);

/// Checks the options as far as possible without a session. Errors: as checkPath, wayPointsOf and readWalk.
[[nodiscard]] Result<play::FramesRequest> checkFrames(const PathArguments& arguments, std::size_t frames,
                                                      const engine::WorldSource& source,
                                                      const Console& console);

} // namespace limen::cli
