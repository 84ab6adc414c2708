#include "play/PathWalk.h"

#include <algorithm>
#include <cmath>

namespace limen::play {
namespace {

Result<CameraPath> makePath(const engine::LoadedPart& loaded,
                            const std::vector<engine::ViewRequest>& points) {
    std::vector<world::Place> places;
    for (const engine::ViewRequest& point : points) {
        // Only the position matters here. Cells of later way points may not be loaded yet.
        engine::ViewRequest position = point;
        position.root = engine::RootChoice{engine::RootChoice::Rule::Outside, 0};
        position.scene = {};
        const Result<engine::FrameRequest> eye = engine::frameRequest(loaded.world, {}, position);
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

std::size_t PathRequest::countOn(const CameraPath& path) const {
    return fps > 0.0 ? std::min(kMostFrames, static_cast<std::size_t>(path.seconds() * fps) + 1) : frames;
}

double PathRequest::timeOf(const CameraPath& path, std::size_t frame) const {
    return fps > 0.0 ? static_cast<double>(frame) / fps : path.timeOfFrame(frame, countOn(path));
}

Result<PathStart> startPath(engine::Session& session, const std::vector<engine::ViewRequest>& points,
                            const PathRequest& request) {
    if (Result<void> loaded = session.load(engine::centreOf(points.front())); !loaded)
        return tl::unexpected(loaded.error());
    engine::ViewRequest first = points.front();
    first.fov = request.fov;
    first.size = request.size;
    first.scene = {};
    Result<engine::FrameRequest> eye =
        engine::frameRequest(session.part().world, session.source().file, first);
    if (!eye)
        return tl::unexpected(eye.error());
    eye->scene.time = request.time;
    return makePath(session.part(), points).map([&](CameraPath path) {
        return PathStart{std::move(path), std::move(*eye)};
    });
}

const engine::FrameRequest& PathWalk::moveTo(double time) {
    eye_.scene.seconds = time;
    path_.cornersBetween(time_, time, corners_);
    const engine::Camera camera = path_.at(time);
    corners_.push_back(camera.eye);
    const double seconds = (time - time_) / static_cast<double>(corners_.size());
    for (const Vec3& corner : corners_) {
        eye_.root = tracker_.move(session_.part().world, eye_.camera.eye, corner, seconds);
        eye_.camera.eye = corner;
    }
    eye_.camera.heading = camera.heading;
    eye_.scene.player = eye_.camera.eye;
    const Vec3 eye = eye_.camera.eye;
    const dat::RecordId cell = engine::cellOf(session_.part().world, eye_.root);
    if (session_.follow(eye, eye_.root) && session_.show()) {
        eye_.root = engine::rootIn(session_.part(), cell, eye);
        tracker_.place(eye_.root);
    }
    time_ = time;
    return eye_;
}

} // namespace limen::play
