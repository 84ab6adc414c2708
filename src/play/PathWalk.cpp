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
        const Result<engine::FrameRequest> frame = engine::frameRequest(loaded.world, {}, position);
        if (!frame)
            return Failure(frame.error());
        world::Place place;
        place.eye = frame->camera.eye;
        place.yaw = frame->camera.heading.yaw;
        place.pitch = frame->camera.heading.pitch;
        if (point.root && point.root->rule == engine::RootChoice::Rule::Cell)
            place.cell = point.root->cell;
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
        return Failure(loaded.error());
    engine::ViewRequest first = points.front();
    first.fov = request.fov;
    first.size = request.size;
    first.scene = {};
    Result<engine::FrameRequest> frame =
        engine::frameRequest(session.part().world, session.source().file, first);
    if (!frame)
        return Failure(frame.error());
    frame->scene.time = request.time;
    return makePath(session.part(), points).map([&](CameraPath path) {
        return PathStart{std::move(path), std::move(*frame)};
    });
}

void PathWalk::jumpTo(const CameraPath::Corner& corner) {
    world::Place place;
    place.eye = corner.eye;
    place.cell = corner.cell;
    static_cast<void>(session_.load(engine::centreOf(engine::requestAt(place)))); // else the old part stays
    frame_.root = engine::rootIn(session_.part(), corner.cell, corner.eye);
    tracker_.place(frame_.root);
}

const engine::FrameRequest& PathWalk::moveTo(double time) {
    frame_.scene.seconds = time;
    path_.cornersBetween(time_, time, corners_);
    const engine::Camera camera = path_.at(time);
    corners_.push_back({camera.eye});
    const double seconds = (time - time_) / static_cast<double>(corners_.size());
    for (const CameraPath::Corner& corner : corners_) {
        if (corner.isJump)
            jumpTo(corner);
        else
            frame_.root = tracker_.move(session_.part().world, frame_.camera.eye, corner.eye, seconds);
        frame_.camera.eye = corner.eye;
    }
    frame_.camera.heading = camera.heading;
    frame_.scene.player = frame_.camera.eye;
    const Vec3 eye = frame_.camera.eye;
    const dat::RecordId cell = engine::cellOf(session_.part().world, frame_.root);
    if (session_.follow(eye, frame_.root) && session_.show()) {
        frame_.root = engine::rootIn(session_.part(), cell, eye);
        tracker_.place(frame_.root);
    }
    time_ = time;
    return frame_;
}

} // namespace limen::play
