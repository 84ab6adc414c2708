#include "play/FrameSource.h"

#include "core/Assert.h"
#include "engine/report/DecisionHash.h"

#include <fmt/format.h>
#include <utility>

namespace limen::play {
namespace {

class PathFrames final : public FrameSource {
public:
    PathFrames(engine::Session& session, PathStart start, const PathRequest& request)
        : start_(std::move(start)), request_(request), walk_(session, start_.path, start_.frame) {}
    std::size_t count() const override { return request_.countOn(start_.path); }
    Result<const engine::FrameRequest*> next() override {
        return &walk_.moveTo(request_.timeOf(start_.path, next_++));
    }

private:
    const PathStart start_;
    const PathRequest request_;
    PathWalk walk_;
    std::size_t next_ = 0;
};

/// Recordings hold no zone option, which does not change pictures, and no readings: a replay compares them.
world::LoadOptions asRecorded(world::LoadOptions load, const engine::Session& session) {
    load.mergeZones = session.options().load.mergeZones;
    load.readings = session.options().load.readings;
    return load;
}

} // namespace

bool RecordedResidency::readNext() {
    offered_.reset();
    const std::optional<engine::PartTarget> next = std::exchange(next_, std::nullopt);
    if (!next)
        return false;
    session_.setLoadOptions(asRecorded(next->options, session_));
    const engine::PartTarget target{next->centre, session_.options().load};
    if (session_.part().target == target)
        return false;
    Result<std::unique_ptr<engine::PartPlanner>> read = session_.read(target);
    if (!read)
        return false;
    offered_ = std::move(*read);
    return true;
}

std::shared_ptr<const engine::LoadedPart> RecordedResidency::follow(const Vec3&, world::SpaceIndex) {
    return readNext() ? offered_->part : nullptr;
}

bool RecordedResidency::show() {
    LIMEN_ASSERT(offered_ != nullptr, "show follows an offer");
    return session_.show(std::move(offered_)).has_value();
}

engine::Passage RecordedResidency::open(dat::BlockCoord centre) {
    if (readNext())
        static_cast<void>(show());
    if (session_.part().target.centre == centre)
        return engine::Passage::Open;
    return isRefused_ ? engine::Passage::Refused : engine::Passage::Coming;
}

Result<std::unique_ptr<ReplayedFrames>> ReplayedFrames::open(engine::Session& session, WalkRecord record,
                                                             const engine::ViewRequest& start) {
    Result<engine::ViewRequest> view = engine::resolvePlace(start, session.source());
    if (!view)
        return Failure(view.error());
    view->size = record.frames.front().input.size;
    if (record.streamed)
        session.setLoadOptions(asRecorded(*record.streamed, session));
    if (Result<void> loaded = session.load(engine::centreOf(*view)); !loaded)
        return Failure(loaded.error());
    Result<engine::FrameRequest> first =
        engine::frameRequest(session.part().world, session.source().file, *view);
    if (!first)
        return Failure(first.error());
    return std::unique_ptr<ReplayedFrames>(new ReplayedFrames(session, std::move(*first), std::move(record)));
}

void ReplayedFrames::compareLast() {
    if (next_ == 0 || difference_)
        return;
    const std::uint64_t decided = record_.frames[next_ - 1].decided;
    if (decided != 0 &&
        decided != engine::decisionHash(play_.request(), session_.visible(), session_.dynamics()))
        difference_ = next_ - 1;
}

Result<const engine::FrameRequest*> ReplayedFrames::next() {
    compareLast();
    const RecordedFrame& frame = record_.frames[next_++];
    residency_.setNext(frame);
    if (Result<void> stepped = play_.step(frame.input); !stepped)
        return Failure(stepped.error());
    return &play_.request();
}

Result<std::unique_ptr<FrameSource>> openFrames(engine::Session& session, FramesRequest request) {
    if (request.walk)
        return ReplayedFrames::open(session, std::move(*request.walk), request.walkStart)
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
    return first
               ? fmt::format("limen: frame {} of the replayed walk differs from the recording; the world or "
                             "the program has changed, so record the walk again",
                             *first)
               : std::string();
}

} // namespace limen::play
