#pragma once

#include "engine/ViewRequest.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace limen::cli {

/// The options that say what one frame looks at, as typed; empty: not given. The same set serves the command
/// line of `shot`, each line of its views file and each line of a tour's path file.
struct ViewArguments {
    std::string eye, at, yaw, pitch, fov, size, root, player, time, day, weather, seconds, doors;
    std::string body, bodyYaw, bodyRoot, bodyOpacity, bodySpeed, bodyMetres;
    std::vector<std::string> eachDoor;
};

/// What a frame is asked to be written to; empty: not asked for.
struct OutputPaths {
    std::filesystem::path frame, ids, depth, json, overlay;
    [[nodiscard]] std::vector<std::filesystem::path> all() const; ///< those that are asked for
};

/// Adds the options of ViewArguments to a command. `withSize` leaves out --size where the verb has one for
/// all frames.
void addViewOptions(CLI::App& command, ViewArguments& arguments);
void addOutputOptions(CLI::App& command, OutputPaths& outputs);

/// Checks every argument. Errors: the first that makes no sense; no eye, or two.
[[nodiscard]] Result<engine::ViewRequest> checkView(const ViewArguments& arguments);

/// The same, of one line of them. `where` begins messages.
[[nodiscard]] Result<engine::ViewRequest> parseView(std::string_view line, const std::string& where);

/// One view of a views file.
struct ListedView {
    engine::ViewRequest view;
    OutputPaths outputs;
};

/// Reads a views file: one line of shot's options each, blank lines and lines that start with '#' left out.
/// What a line does not say it takes from `common`. Relative output paths of a line are under `directory`; a
/// line that names none gets `directory`/NNNN.png (and for every output in `common` `directory`/NNNN.<its
/// file name>), NNNN from 0000 in the order of views. Errors: unreadable, no view in it, a line that makes no
/// sense (its number is in the message).
[[nodiscard]] Result<std::vector<ListedView>> readViews(const std::filesystem::path& file,
                                                        const ViewArguments& common,
                                                        const OutputPaths& commonOutputs,
                                                        const std::filesystem::path& directory);

/// Says for all outputs at once whether they can be written, and that no two are the same file.
[[nodiscard]] Result<void> checkOutputs(std::span<const std::filesystem::path> outputs);

} // namespace limen::cli
