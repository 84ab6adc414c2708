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

/// The options of one view as typed; empty: not given. They are used on the command line of `shot`, in each
/// line of its views file and in each line of a path file.
struct ViewArguments {
    std::string eye, at, yaw, pitch, fov, size, root, player, time, day, date, weather, look, seconds, doors;
    std::string body, bodyYaw, bodyRoot, bodyOpacity, bodySpeed, bodyMetres;
    std::vector<std::string> eachDoor;
};

/// The output files of a frame; empty: not written.
struct OutputPaths {
    std::filesystem::path frame, ids, depth, json, overlay;
    [[nodiscard]] std::vector<std::filesystem::path> all() const; ///< the paths that are not empty
};

/// Adds the options of ViewArguments or OutputPaths to a command.
void addViewOptions(CLI::App& command, ViewArguments& arguments);
void addOutputOptions(CLI::App& command, OutputPaths& outputs);

/// Checks all arguments. Without a viewpoint the request is at the world's start. Errors: the first invalid
/// argument; two viewpoints.
[[nodiscard]] Result<engine::ViewRequest> checkView(const ViewArguments& arguments);

/// Parses and checks a line of view options, which must give a viewpoint. Messages start with `where`.
[[nodiscard]] Result<engine::ViewRequest> parseView(std::string_view line, const std::string& where);

/// One view of a views file.
struct ListedView {
    engine::ViewRequest view;
    OutputPaths outputs;
};

/// Reads a views file: one line of shot's options per view. Blank lines and lines that start with '#' are
/// ignored. Missing options are taken from `common`.
///
/// Relative output paths of a line are under `directory`. A line without outputs gets `directory`/NNNN.png,
/// and `directory`/NNNN.<file name> for every output of `commonOutputs`; NNNN counts views from 0000.
///
/// Errors: an unreadable file; no view; an invalid line, with its number.
[[nodiscard]] Result<std::vector<ListedView>> readViews(const std::filesystem::path& file,
                                                        const ViewArguments& common,
                                                        const OutputPaths& commonOutputs,
                                                        const std::filesystem::path& directory);

/// Checks that all outputs can be written and that no two are the same file.
[[nodiscard]] Result<void> checkOutputs(std::span<const std::filesystem::path> outputs);

} // namespace limen::cli
