#include "engine/stream/StreamedResidency.h"

#include "core/Assert.h"
#include "engine/HeapTuning.h"
#include "frame/SceneBuilder.h"

#include <algorithm>
#include <thread>
#include <utility>

namespace limen::engine {
namespace {

/// Half of the processors: the others draw, or serve other programs.
unsigned threadsToReadOn() {
    return std::max(std::thread::hardware_concurrency() / 2, 1u);
}

void giveBack(bool wanted) {
    if (wanted)
        giveBackFreeMemory();
}

} // namespace

StreamedResidency::StreamedResidency(Session& session) : session_(session) {
    LIMEN_ASSERT(session.isLoaded(), "streaming begins with a loaded part");
    // On failure the first part only takes more frames to upload.
    static_cast<void>(session_.renderer().makeRoom());
    giveBack(session_.options().givesMemoryBack); // memory that loading needed
}

std::shared_ptr<const LoadedPart> StreamedResidency::follow(const Vec3& eye, world::SpaceIndex root) {
    const LoadedPart& shown = session_.part();
    const dat::RecordId cell = cellOf(shown.world, root);
    return step({eye, blockAround(session_.source().archive, shown, cell, eye)}) ? coming_.planner->part
                                                                                 : nullptr;
}

bool StreamedResidency::step(const StreamEye& eye) {
    justShown_.reset();
    hasRefused_ = false;
    isOffered_ = false;
    const StreamProgress done = progress(eye.isAway ? kBytesWhileWaiting : kBytesPerFrame);
    carryOut(streamer_.step(session_.part().target, eye, session_.options().load, done));
    return isOffered_;
}

StreamProgress StreamedResidency::progress(std::size_t bytes) {
    StreamProgress progress;
    // Needed in every frame, also without an upload: it frees scenes that are no longer drawn.
    const Result<bool> uploaded = session_.renderer().advance(bytes);
    if (isUploading_) {
        progress.isUploaded = uploaded && *uploaded;
        if (!uploaded)
            progress.error = uploaded.error();
        if (uploadError_)
            progress.error = std::exchange(uploadError_, std::nullopt);
        return progress;
    }
    if (!reading_.valid() || !Background::isReady(reading_))
        return progress;
    progress.isRead = true;
    Result<Coming> read = reading_.get();
    if (read)
        coming_ = std::move(*read);
    else
        progress.error = read.error();
    return progress;
}

void StreamedResidency::carryOut(StreamCommand command) {
    switch (command) {
    case StreamCommand::None:
        return;
    case StreamCommand::Read:
        return beginToRead(streamer_.coming());
    case StreamCommand::Upload:
        return beginToUpload();
    case StreamCommand::Drop:
        return drop();
    case StreamCommand::Offer:
        isOffered_ = true;
        return;
    }
}

bool StreamedResidency::show() {
    LIMEN_ASSERT(isOffered_, "show follows an offer of the same frame");
    isUploading_ = isOffered_ = false;
    session_.renderer().swap();
    coming_.planner = session_.take(std::move(coming_.planner));
    release();
    streamer_.shown();
    justShown_ = session_.part().target;
    return true;
}

Passage StreamedResidency::open(dat::BlockCoord centre) {
    const Vec3 middle = Vec3(centre.x + 0.5, centre.y + 0.5, 0.0) * world::kBlockSize;
    if (step({middle, centre, true}))
        static_cast<void>(show());
    if (session_.part().target.centre == centre)
        return Passage::Open;
    hasRefused_ = streamer_.hasFailed({centre, session_.options().load});
    return hasRefused_ ? Passage::Refused : Passage::Coming;
}

Result<StreamedResidency::Coming> StreamedResidency::read(const Session& session, const PartTarget& target,
                                                          const gpu::RendererOptions& options,
                                                          const gpu::SceneState& before) {
    Result<std::unique_ptr<PartPlanner>> part = session.read(target, threadsToReadOn());
    if (!part)
        return Failure(part.error());
    frame::SceneUpload scene = frame::buildScene((*part)->part->scene);
    Result<gpu::StagedScene> staged =
        gpu::stageScene(std::move(scene), options, session.capabilities(), before);
    if (!staged)
        return Failure(staged.error());
    return Coming{std::move(*part), std::make_unique<gpu::StagedScene>(std::move(*staged)), {}};
}

void StreamedResidency::beginToRead(const PartTarget& target) {
    LIMEN_ASSERT(!reading_.valid() && !isUploading_, "one part comes at a time");
    // The work takes copies, because the session continues meanwhile. `session` itself is only read through
    // `read`.
    reading_ = background_.run([&session = std::as_const(session_), target,
                                options = session_.renderer().options(), before = session_.renderer().state(),
                                givesBack = session_.options().givesMemoryBack] {
        Result<Coming> coming = read(session, target, options, before);
        giveBack(givesBack); // memory that reading needed
        return coming;
    });
}

void StreamedResidency::beginToUpload() {
    LIMEN_ASSERT(coming_.planner != nullptr && coming_.scene != nullptr, "a part was read and staged");
    isUploading_ = true;
    coming_.arrays = coming_.scene->arrays;
    if (const Result<void> begun = session_.renderer().begin(std::move(*coming_.scene)); !begun)
        uploadError_ = begun.error();
}

void StreamedResidency::release() {
    background_.discard(std::make_shared<Coming>(std::exchange(coming_, {})),
                        [givesBack = session_.options().givesMemoryBack] { giveBack(givesBack); });
}

void StreamedResidency::drop() {
    if (std::exchange(isUploading_, false))
        session_.renderer().drop();
    release();
}

} // namespace limen::engine
