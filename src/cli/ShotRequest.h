#pragma once

#include "engine/Camera.h"
#include "cli/PlaceNotation.h"
#include "check/View.h"

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

/// The player's body in a frame.
struct BodyRequest {
    Vec3 feet{0.0};
    double yaw = 0.0;
    RootChoice root;
    double opacity = 1.0;
    double speed = 0.0, metres = 0.0;
};

/// One frame, checked as far as that goes without a world.
struct ViewRequest {
    std::optional<Vec3> eye;
    std::optional<PlaceNotation> at;
    std::optional<double> yaw, pitch; ///< degrees
    double fov = 60.0;                ///< vertical, degrees
    PixelSize size;
    std::optional<RootChoice> root; ///< only if it was given
    std::optional<Vec3> player;
    double time = 0.5; ///< fraction of the day
    std::string day;   ///< a day group, as world::dayGroupNamed reads it; empty: the first
    Weather weather = Weather::Clear;
    double seconds = 0.0;        ///< since the world began
    std::optional<double> doors; ///< how far all doors stand open, 0..1; none: each as eachDoor says
    std::vector<check::View::DoorState> eachDoor; ///< doors that do not rest
    std::optional<BodyRequest> body;
};

/// Adds the options of ViewArguments to a command. `withSize` leaves out --size where the verb has one for
/// all frames.
void addViewOptions(CLI::App& command, ViewArguments& arguments);
void addOutputOptions(CLI::App& command, OutputPaths& outputs);

/// Checks every argument. Errors: the first that makes no sense; no eye, or two.
[[nodiscard]] Result<ViewRequest> checkView(const ViewArguments& arguments);

/// The same, of one line of them. `where` begins messages.
[[nodiscard]] Result<ViewRequest> parseView(std::string_view line, const std::string& where);

/// One view of a views file.
struct ListedView {
    ViewRequest view;
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
