#include "play/PathWalk.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace limen::play {
namespace {

Result<CameraPath> makePath(const engine::LoadedWorld& loaded, const std::vector<engine::Viewpoint>& points, cli::PixelSize size) {
    std::vector<world::Place> places;
    for (const engine::Viewpoint& point : points) {
        engine::Viewpoint free =
            point; // only the position matters here; cells of later way points may not be loaded yet
        free.root = {cli::RootChoice::Kind::Outside, 0};
        const Result<engine::FrameEye> eye = engine::placeEye(loaded, free, size);
        if (!eye)
            return tl::unexpected(eye.error());
        world::Place place;
        place.eye = eye->camera.eye;
        place.yaw = eye->camera.heading.yaw;
        place.pitch = eye->camera.heading.pitch;
        places.push_back(std::move(place));
    }
    return CameraPath(places);
}

} // namespace

void addPathOptions(CLI::App& command, PathArguments& arguments, std::size_t frames) {
    command
        .add_option("--path", arguments.path,
                    "way points, one line of shot's options each; the world's own tour unless said")
        ->type_name("FILE");
    CLI::Option* walk = command
                            .add_option("--walk", arguments.walk,
                                        "or a walk that limen view --record has written, frame by frame")
                            ->type_name("FILE")
                            ->excludes("--path");
    command.add_option("--size", arguments.size, "picture size in pixels (960x540, of a walk as recorded)")
        ->type_name("WxH");
    command
        .add_option("--frames", arguments.frames, fmt::format("how many frames, spread evenly ({})", frames))
        ->type_name("N")
        ->excludes(walk);
    command.add_option("--fps", arguments.fps, "or how many for each second of walking")
        ->type_name("F")
        ->excludes(walk);
    command.add_option("--fov", arguments.fov, "vertical field of view (60)")
        ->type_name("DEG")
        ->excludes(walk);
    command.add_option("--time", arguments.time, "time of day, 0 and 1 midnight (0.5)")
        ->type_name("0..1")
        ->excludes(walk);
}

std::size_t PathRequest::countOn(const CameraPath& path) const {
    return fps > 0.0 ? std::min(kMostFrames, static_cast<std::size_t>(path.seconds() * fps) + 1) : frames;
}

double PathRequest::timeOf(const CameraPath& path, std::size_t frame) const {
    return fps > 0.0 ? static_cast<double>(frame) / fps : path.timeOfFrame(frame, countOn(path));
}

Result<PathRequest> checkPath(const PathArguments& arguments, std::size_t frames) {
    PathRequest request;
    const Result<cli::PixelSize> size = cli::parseSize("--size", arguments.size.empty() ? "960x540" : arguments.size);
    if (!size)
        return tl::unexpected(size.error());
    request.size = *size;
    if (!arguments.frames.empty() && !arguments.fps.empty())
        return fail(ErrorCode::BadArgument, "--fps", "give either --frames or --fps, not both");
    struct Number {
        const char* option;
        const std::string& text;
        double low, high;
        double& value;
    };
    auto count = static_cast<double>(frames);
    for (const Number& n :
         {Number{"--fov", arguments.fov, 0.1, 179.0, request.fov},
          Number{"--time", arguments.time, 0.0, 1.0, request.time},
          Number{"--frames", arguments.frames, 1.0, static_cast<double>(PathRequest::kMostFrames), count},
          Number{"--fps", arguments.fps, 0.01, 1000.0, request.fps}}) {
        if (n.text.empty())
            continue;
        const Result<double> number = cli::parseNumberBetween(n.option, n.text, n.low, n.high);
        if (!number)
            return tl::unexpected(number.error());
        n.value = *number;
    }
    if (count != std::floor(count))
        return fail(ErrorCode::BadArgument, "--frames",
                    fmt::format("'{}' is not a whole number", arguments.frames));
    request.frames = static_cast<std::size_t>(count);
    return request;
}

Result<std::vector<engine::Viewpoint>> wayPointsOf(const PathArguments& arguments, const world::WorldFile& file) {
    std::vector<engine::Viewpoint> points;
    if (arguments.path.empty()) {
        for (const world::Place& place : file.tour)
            points.push_back(engine::viewpointAt(place));
        if (points.empty())
            return fail(ErrorCode::NotFound, "tour",
                        "this world's world.json has no tour; give way points with --path FILE");
        return points;
    }
    const Result<std::vector<cli::ListedView>> views = cli::readViews(arguments.path, {}, {}, "");
    if (!views)
        return tl::unexpected(views.error());
    for (const cli::ListedView& listed : *views) {
        Result<engine::Viewpoint> stand = engine::viewpointOf(listed.view, file);
        if (!stand)
            return tl::unexpected(stand.error());
        points.push_back(*stand);
    }
    return points;
}

Result<PathStart> startPath(engine::Session& session, const std::vector<engine::Viewpoint>& points,
                            const PathRequest& request) {
    if (Result<void> loaded = session.load(points.front().centre); !loaded)
        return tl::unexpected(loaded.error());
    engine::Viewpoint first = points.front();
    first.camera.fovDegrees = request.fov;
    Result<engine::FrameEye> eye = engine::placeEye(session.loaded(), first, request.size);
    if (!eye)
        return tl::unexpected(eye.error());
    eye->time = request.time;
    return makePath(session.loaded(), points, request.size).map([&](CameraPath path) {
        return PathStart{std::move(path), std::move(*eye)};
    });
}

const engine::FrameEye& PathWalk::moveTo(double time) {
    eye_.seconds = time;
    path_.cornersBetween(time_, time, corners_);
    const engine::Camera camera = path_.at(time);
    corners_.push_back(camera.eye);
    const double seconds = (time - time_) / static_cast<double>(corners_.size());
    for (const Vec3& corner : corners_) {
        eye_.root = tracker_.move(session_.loaded().world, eye_.camera.eye, corner, seconds);
        eye_.camera.eye = corner;
    }
    eye_.camera.heading = camera.heading;
    eye_.player = eye_.camera.eye;
    if (session_.follow(eye_.camera.eye, eye_.root, nullptr))
        tracker_.place(eye_.root);
    time_ = time;
    return eye_;
}

} // namespace limen::play
