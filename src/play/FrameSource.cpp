#include "play/FrameSource.h"

#include "engine/DecisionHash.h"

#include <fmt/format.h>
#include <utility>

namespace limen::play {
namespace {

class PathFrames final : public FrameSource {
public:
    PathFrames(engine::Session& session, PathStart start, const PathRequest& request)
        : start_(std::move(start)), request_(request), walk_(session, start_.path, start_.eye) {}
    std::size_t count() const override { return request_.countOn(start_.path); }
    Result<const engine::FrameEye*> next() override { return &walk_.moveTo(request_.timeOf(start_.path, next_++)); }

private:
    const PathStart start_;
    const PathRequest request_;
    PathWalk walk_;
    std::size_t next_ = 0;
};

/// Records do not tell how cells were joined.
world::LoadOptions sameZones(world::LoadOptions load, const engine::Session& session) {
    load.mergeZones = session.options().load.mergeZones;
    return load;
}

/// All frames of one size, if that is asked for. What is seen may be another part of the world then, so nothing is compared.
Result<void> resize(const std::string& text, WalkRecord& walk) {
    if (text.empty())
        return {};
    const Result<cli::PixelSize> size = cli::parseSize("--size", text);
    if (!size)
        return tl::unexpected(size.error());
    for (RecordedFrame& frame : walk.frames) {
        frame.decided = frame.input.size == *size ? frame.decided : 0;
        frame.input.size = *size;
    }
    return {};
}

} // namespace

bool RecordedResidency::loadNext() {
    const std::optional<engine::StreamTarget> next = std::exchange(next_, std::nullopt);
    if (!next)
        return false;
    session_.loadBy(sameZones(next->options, session_));
    return session_.load(next->centre).has_value();
}

bool RecordedResidency::follow(const Vec3& eye, world::SpaceIndex& root, Walk*) {
    const dat::RecordId cell = root == world::kOutside ? 0 : session_.loaded().world.spaces[root].cellId;
    if (!loadNext())
        return false;
    root = engine::rootIn(session_.loaded(), cell, eye);
    return true;
}

engine::Passage RecordedResidency::open(dat::BlockCoord centre) {
    static_cast<void>(loadNext());
    if (session_.loaded().target.centre == centre)
        return engine::Passage::Open;
    return isRefused_ ? engine::Passage::Refused : engine::Passage::Coming;
}

Result<std::unique_ptr<ReplayedFrames>> ReplayedFrames::open(engine::Session& session, WalkRecord record) {
    const Result<cli::ViewRequest> view = cli::parseView(record.start, "the walk's beginning");
    if (!view)
        return tl::unexpected(view.error());
    const Result<engine::Viewpoint> stand = engine::viewpointOf(*view, session.source().file);
    if (!stand)
        return tl::unexpected(stand.error());
    if (record.streamed)
        session.loadBy(sameZones(*record.streamed, session));
    if (Result<void> loaded = session.load(stand->centre); !loaded)
        return tl::unexpected(loaded.error());
    Result<engine::FrameEye> start = engine::placeEye(session.loaded(), *stand, record.frames.front().input.size);
    if (!start)
        return tl::unexpected(start.error());
    if (Result<void> applied = engine::applyDynamics(session.loaded(), session.source().file, *view, *start);
        !applied)
        return tl::unexpected(applied.error());
    return std::unique_ptr<ReplayedFrames>(new ReplayedFrames(session, std::move(*start), std::move(record)));
}

void ReplayedFrames::compareLast() {
    if (next_ == 0 || difference_)
        return;
    const std::uint64_t decided = record_.frames[next_ - 1].decided;
    if (decided != 0 && decided != engine::decisionHash(play_.eye(), session_.visible(), session_.dynamics()))
        difference_ = next_ - 1;
}

Result<const engine::FrameEye*> ReplayedFrames::next() {
    compareLast();
    const RecordedFrame& frame = record_.frames[next_++];
    residency_.goOn(frame);
    if (Result<void> stepped = play_.step(frame.input); !stepped)
        return tl::unexpected(stepped.error());
    return &play_.eye();
}

Result<FramesRequest> checkFrames(const PathArguments& arguments, std::size_t frames,
                                  const world::WorldFile& file) {
    FramesRequest request;
    if (!arguments.walk.empty()) {
        Result<WalkRecord> walk = readWalk(arguments.walk);
        if (!walk)
            return tl::unexpected(walk.error());
        if (Result<void> sized = resize(arguments.size, *walk); !sized)
            return tl::unexpected(sized.error());
        request.walk = std::move(*walk);
        return request;
    }
    const Result<PathRequest> path = checkPath(arguments, frames);
    if (!path)
        return tl::unexpected(path.error());
    request.path = *path;
    Result<std::vector<engine::Viewpoint>> points = wayPointsOf(arguments, file);
    if (!points)
        return tl::unexpected(points.error());
    request.points = std::move(*points);
    return request;
}

Result<std::unique_ptr<FrameSource>> openFrames(engine::Session& session, FramesRequest request) {
    if (request.walk)
        return ReplayedFrames::open(session, std::move(*request.walk))
            .map([](std::unique_ptr<ReplayedFrames> frames) -> std::unique_ptr<FrameSource> {
                return frames;
            });
    return startPath(session, request.points, request.path)
        .map([&](PathStart start) -> std::unique_ptr<FrameSource> {
            return std::make_unique<PathFrames>(session, std::move(start), request.path);
        });
}

std::string differenceLine(FrameSource& frames) {
    const std::optional<std::size_t> first = frames.firstDifference();
    return first ? fmt::format("limen: frame {} of the walk came out otherwise than when it was recorded: "
                               "the world or the "
                               "program is not the same",
                               *first)
                 : std::string();
}

} // namespace limen::play
