#include "cli/PathArguments.h"

#include "cli/OpenWorld.h"
#include "cli/Parse.h"
#include "cli/ShotRequest.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <fmt/format.h>

namespace limen::cli {
namespace {

/// Gives all frames of a walk the size `text`, if it is not empty. Another size can change visibility, so
/// resized frames are not compared with the recording.
Result<void> resize(const std::string& text, play::WalkRecord& walk) {
    if (text.empty())
        return {};
    const Result<engine::PixelSize> size = parseSize("--size", text);
    if (!size)
        return Failure(size.error());
    for (play::RecordedFrame& frame : walk.frames) {
        frame.decided = frame.input.size == *size ? frame.decided : 0;
        frame.input.size = *size;
    }
    return {};
}

} // namespace

void addPathOptions(CLI::App& command, PathArguments& arguments, std::size_t frames) {
    command
        .add_option("--path", arguments.path,
                    "follow these way points, one line of shot's options each, e.g. --at hill (the world's "
                    "tour, else one made from its records)")
        ->type_name("FILE");
    CLI::Option* walk =
        command
            .add_option(
                "--walk", arguments.walk,
                "replay a walk recorded with limen view --record or limen walk, frame by frame (none)")
            ->type_name("FILE")
            ->excludes("--path");
    command
        .add_option("--size", arguments.size,
                    "set the picture size in pixels (960x540; for a walk as recorded)")
        ->type_name("WxH");
    command
        .add_option("--frames", arguments.frames,
                    fmt::format("draw this many frames, spread evenly over the path ({})", frames))
        ->type_name("N")
        ->excludes(walk);
    command
        .add_option("--fps", arguments.fps,
                    "draw this many frames per second of the path, instead of --frames (none)")
        ->type_name("F")
        ->excludes(walk);
    command.add_option("--fov", arguments.fov, "set the vertical field of view in degrees (60)")
        ->type_name("DEG")
        ->excludes(walk);
    command.add_option("--time", arguments.time, "set the time of day; 0 and 1 are midnight (0.5)")
        ->type_name("0..1")
        ->excludes(walk);
}

Result<play::PathRequest> checkPath(const PathArguments& arguments, std::size_t frames) {
    play::PathRequest request;
    const Result<engine::PixelSize> size =
        parseSize("--size", arguments.size.empty() ? "960x540" : arguments.size);
    if (!size)
        return Failure(size.error());
    request.size = *size;
    if (!arguments.frames.empty() && !arguments.fps.empty())
        return fail(ErrorCode::BadArgument, "--fps", "--frames is given as well; give only one of the two");
    struct Number {
        const char* option;
        const std::string& text;
        double low, high;
        double& value;
    };
    auto count = static_cast<double>(frames);
    for (const Number& n : {Number{"--fov", arguments.fov, 0.1, 179.0, request.fov},
                            Number{"--time", arguments.time, 0.0, 1.0, request.time},
                            Number{"--frames", arguments.frames, 1.0,
                                   static_cast<double>(play::PathRequest::kMostFrames), count},
                            Number{"--fps", arguments.fps, 0.01, 1000.0, request.fps}}) {
        if (n.text.empty())
            continue;
        const Result<double> number = parseNumberBetween(n.option, n.text, n.low, n.high);
        if (!number)
            return Failure(number.error());
        n.value = *number;
    }
    if (count != std::floor(count))
        return fail(ErrorCode::BadArgument, "--frames",
                    fmt::format("'{}' is not a whole number; give one such as 120", arguments.frames));
    request.frames = static_cast<std::size_t>(count);
    return request;
}

Result<std::vector<engine::ViewRequest>>
wayPointsOf(const PathArguments& arguments, const engine::WorldSource& source, const Console& console) {
    std::vector<engine::ViewRequest> points;
    if (arguments.path.empty()) {
        const Result<std::vector<world::Place>> tour = tourOf(console, source);
        if (!tour)
            return Failure(tour.error());
        for (const world::Place& place : *tour)
            points.push_back(engine::requestAt(place));
        if (points.empty())
            return fail(ErrorCode::NotFound, "tour",
                        "this world has no tour, and none was found in its records; give way points with "
                        "--path FILE");
        return points;
    }
    const Result<std::vector<ListedView>> views = readViews(arguments.path, {}, {}, "");
    if (!views)
        return Failure(views.error());
    for (const ListedView& listed : *views) {
        Result<engine::ViewRequest> stand = engine::resolvePlace(listed.view, source);
        if (!stand)
            return Failure(stand.error());
        points.push_back(*stand);
    }
    return points;
}

Result<engine::ViewRequest> walkStart(const play::WalkRecord& walk) {
    return parseView(walk.start, "the start of the walk");
}

Result<play::FramesRequest> checkFrames(const PathArguments& arguments, std::size_t frames,
                                        const engine::WorldSource& source, const Console& console) {
    play::FramesRequest request;
    if (!arguments.walk.empty()) {
        Result<play::WalkRecord> walk = play::readWalk(arguments.walk);
        if (!walk)
            return Failure(walk.error());
        if (Result<void> sized = resize(arguments.size, *walk); !sized)
            return Failure(sized.error());
        Result<engine::ViewRequest> start = walkStart(*walk);
        if (!start)
            return Failure(start.error());
        request.walk = std::move(*walk);
        request.walkStart = std::move(*start);
        return request;
    }
    const Result<play::PathRequest> path = checkPath(arguments, frames);
    if (!path)
        return Failure(path.error());
    request.path = *path;
    Result<std::vector<engine::ViewRequest>> points = wayPointsOf(arguments, source, console);
    if (!points)
        return Failure(points.error());
    request.points = std::move(*points);
    return request;
}

} // namespace limen::cli
