#include "app/SessionStream.h"

#include "app/Walk.h"
#include "frame/SceneBuilder.h"

#include <thread>
#include <utility>

namespace limen::app {
namespace {

/// The others draw, or belong to somebody else.
unsigned threadsToReadOn() {
    return std::max(std::thread::hardware_concurrency() / 2, 1u);
}

} // namespace

SessionStream::SessionStream(Session& session) : session_(session) {
    static_cast<void>(session_.renderer().makeRoom()); // without it the first part only costs frames more
}

bool SessionStream::follow(const Vec3& eye, world::SpaceIndex& root, Walk* walk) {
    const LoadedWorld& before = session_.loaded();
    const dat::RecordId cell = root == world::kOutside ? 0 : before.world.spaces[root].cellId;
    const StreamEye place{eye, blockAround(session_.source().archive, before, cell, eye)};
    walk_ = walk;
    if (!step(place))
        return false;
    root = rootIn(session_.loaded(), cell, eye);
    return true;
}

bool SessionStream::step(const StreamEye& eye) {
    justShown_.reset();
    hasRefused_ = false;
    bytesPerFrame_ = eye.isAway ? kBytesWhileWaiting : kBytesPerFrame;
    const StreamTarget shown = session_.loaded().target; // it may go meanwhile
    if (!streamer_.step(shown, eye, session_.options().load))
        return false;
    justShown_ = session_.loaded().target;
    return true;
}

Passage SessionStream::open(dat::BlockCoord centre) {
    walk_ = nullptr; // the body stays where it is
    const Vec3 middle = Vec3(centre.x + 0.5, centre.y + 0.5, 0.0) * world::kBlockSize;
    static_cast<void>(step({middle, centre, true}));
    if (session_.loaded().target.centre == centre)
        return Passage::Open;
    hasRefused_ = streamer_.hasFailed({centre, session_.options().load});
    return hasRefused_ ? Passage::Refused : Passage::Coming;
}

Result<SessionStream::Part> SessionStream::read(const Session& session, const StreamTarget& target,
                                                const gpu::RendererOptions& options,
                                                const gpu::SceneState& before) {
    Result<std::shared_ptr<LoadedWorld>> loaded = session.read(target, threadsToReadOn());
    if (!loaded)
        return tl::unexpected(loaded.error());
    frame::SceneUpload scene = frame::buildScene((*loaded)->scene);
    Result<gpu::StagedScene> staged =
        gpu::stageScene(std::move(scene), options, session.capabilities(), before);
    if (!staged)
        return tl::unexpected(staged.error());
    return Part{std::move(*loaded), std::make_unique<gpu::StagedScene>(std::move(*staged)), {}};
}

void SessionStream::beginToRead(const StreamTarget& target) {
    // Copies: the session goes on meanwhile.
    reading_ = background_.run(
        [&session = std::as_const(session_), target, options = session_.renderer().options(),
         before = session_.renderer().state()] { return read(session, target, options, before); });
}

std::optional<Result<void>> SessionStream::pollRead() {
    if (!Background::isReady(reading_))
        return std::nullopt;
    Result<Part> part = reading_.get();
    if (!part)
        return tl::unexpected(part.error());
    coming_ = std::move(*part);
    return Result<void>{};
}

Result<void> SessionStream::beginToUpload() {
    isUploading_ = true;
    coming_.arrays = coming_.scene->arrays;
    return session_.renderer().begin(std::move(*coming_.scene));
}

Result<bool> SessionStream::advance() {
    const Result<bool> isThere = session_.renderer().advance(bytesPerFrame_);
    if (!isThere || !*isThere || !isUploading_)
        return isThere;
    return walk_ == nullptr || walk_->prepare(session_, coming_.loaded);
}

void SessionStream::drop() {
    if (std::exchange(isUploading_, false))
        session_.renderer().drop();
    background_.discard(std::make_shared<Part>(std::exchange(coming_, {})));
}

void SessionStream::show() {
    isUploading_ = false;
    session_.renderer().swap();
    coming_.loaded = session_.take(std::move(coming_.loaded));
    background_.discard(std::make_shared<Part>(std::exchange(coming_, {})));
}

} // namespace limen::app
