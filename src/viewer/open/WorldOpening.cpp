#include "viewer/open/WorldOpening.h"

#include "core/Assert.h"
#include "engine/FrameRequest.h"
#include "frame/SceneBuilder.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

namespace limen::viewer {
namespace {

constexpr std::size_t kSlice = std::size_t{8} << 20; // bytes a frame: nobody walks meanwhile

template <class T>
bool isThere(const std::future<T>& future) {
    return future.valid() && future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

std::size_t bytesOfUpload(const gpu::StagedScene& scene) {
    const auto size = [](const auto& list) { return list.size() * sizeof(list[0]); };
    const frame::SceneUpload& arrays = *scene.arrays;
    std::size_t bytes = size(arrays.vertices) + size(arrays.indices) + size(arrays.instances) +
                        size(arrays.members) + size(arrays.pieces) + size(arrays.materials) +
                        size(arrays.materialRefs) + size(arrays.terrainCells) + size(arrays.lightSets) +
                        size(arrays.lampRefs);
    for (const gpu::StagedTexture& texture : scene.textures.textures)
        for (const std::vector<gpu::MipLevel>& layer : texture.layers)
            for (const gpu::MipLevel& level : layer)
                bytes += level.rgba.size();
    return bytes;
}

/// Half of the processors: the others draw.
unsigned openingThreads() {
    return std::max(std::thread::hardware_concurrency() / 2, 1u);
}

} // namespace

WorldOpening::WorldOpening(gpu::Device& device, OpenRequest request)
    : device_(device), request_(std::move(request)),
      finding_(std::async(std::launch::async, [this] { return find(); })) {}

WorldOpening::~WorldOpening() {
    cancel();
}

void WorldOpening::cancel() {
    progress_->isCancelled = true;
}

bool WorldOpening::isIdle() const {
    return (!finding_.valid() || isThere(finding_)) && (!reading_.valid() || isThere(reading_));
}

void WorldOpening::wait(double seconds) const {
    const std::chrono::duration<double> most(seconds);
    if (finding_.valid())
        finding_.wait_for(most);
    else if (reading_.valid())
        reading_.wait_for(most);
}

Result<WorldOpening::Found> WorldOpening::find() {
    const auto count = [this](std::size_t done, std::size_t all) {
        toSearch_ = all;
        searched_ = done;
        return !progress_->isCancelled;
    };
    Result<engine::WorldSource> source =
        engine::openWorldSource(request_.directory, engine::PlaceSearch::Find, count);
    if (!source)
        return Failure(source.error());
    auto shared = std::make_shared<const engine::WorldSource>(std::move(*source));
    Result<engine::ViewRequest> view = request_.start(*shared);
    if (!view)
        return Failure(view.error());
    return Found{std::move(shared), std::move(*view)};
}

Result<WorldOpening::Read> WorldOpening::read() const {
    const engine::PartTarget target{engine::centreOf(view_), session_->options().load};
    Result<std::unique_ptr<engine::PartPlanner>> part =
        session_->read(target, openingThreads(), progress_.get());
    if (!part)
        return Failure(part.error());
    Result<gpu::StagedScene> staged =
        gpu::stageScene(frame::buildScene((*part)->part->scene), session_->renderer().options(),
                        session_->capabilities(), {});
    if (!staged)
        return Failure(staged.error());
    return Read{std::move(*part), std::make_unique<gpu::StagedScene>(std::move(*staged))};
}

Result<bool> WorldOpening::step() {
    if (Result<void> advanced = advance(); !advanced)
        return Failure(advanced.error());
    return phase_ == Phase::Ready;
}

Result<void> WorldOpening::advance() {
    switch (phase_) {
    case Phase::Files:
        if (isThere(finding_)) {
            Result<Found> found = finding_.get();
            if (!found)
                return Failure(found.error());
            view_ = std::move(found->view);
            session_ = std::make_unique<engine::Session>(std::move(found->source), request_.options, device_);
            phase_ = Phase::Renderer;
        }
        return {};
    case Phase::Renderer: // a phase of its own, so that the page names it before the driver compiles shaders
        reading_ = std::async(std::launch::async, [this] { return read(); });
        phase_ = Phase::Blocks;
        return {};
    case Phase::Blocks:
        return isThere(reading_) ? beginUpload() : Result<void>{};
    case Phase::Upload: {
        const Result<bool> uploaded = session_->renderer().advance(kSlice);
        if (!uploaded)
            return Failure(uploaded.error());
        sent_ = std::min(sent_ + kSlice, bytes_);
        return *uploaded ? finish() : Result<void>{};
    }
    case Phase::Ready:
        return {};
    }
    return {};
}

Result<void> WorldOpening::beginUpload() {
    Result<Read> read = reading_.get();
    if (!read)
        return Failure(read.error());
    planner_ = std::move(read->planner);
    arrays_ = read->scene->arrays;
    bytes_ = bytesOfUpload(*read->scene);
    phase_ = Phase::Upload;
    return session_->renderer().begin(std::move(*read->scene));
}

Result<void> WorldOpening::finish() {
    session_->renderer().swap();
    planner_ = session_->take(std::move(planner_)); // null: there was no part before
    arrays_.reset();
    const Result<engine::FrameRequest> start =
        engine::frameRequest(session_->part().world, session_->source().file, view_);
    if (!start)
        return Failure(start.error());
    start_ = *start;
    phase_ = Phase::Ready;
    return {};
}

OpenedWorld WorldOpening::take() {
    LIMEN_ASSERT(phase_ == Phase::Ready, "the world is ready");
    return {std::move(session_), std::move(start_)};
}

LoadingFacts WorldOpening::facts() const {
    LoadingFacts facts;
    facts.toSearch = phase_ == Phase::Files ? toSearch_.load() : 0;
    facts.searched = std::min(searched_.load(), facts.toSearch);
    facts.blocks = progress_->blocks;
    facts.blocksRead = std::min(progress_->done.load(), facts.blocks);
    facts.uploaded = phase_ == Phase::Ready ? 1.0
                     : bytes_ > 0           ? static_cast<double>(sent_) / static_cast<double>(bytes_)
                                            : 0.0;
    switch (phase_) {
    case Phase::Files:
        facts.step = facts.toSearch > 0           ? "searching for places"
                     : request_.directory.empty() ? "writing and opening the built-in world"
                                                  : "opening the files";
        break;
    case Phase::Renderer:
        facts.step = "preparing the graphics card";
        break;
    case Phase::Blocks:
        facts.step = facts.blocks > 0 && facts.blocksRead == facts.blocks ? "building the scene"
                                                                          : "reading landblocks";
        break;
    case Phase::Upload:
        facts.step = sent_ < bytes_ ? "uploading meshes and textures" : "building shaders";
        break;
    case Phase::Ready:
        facts.step = "ready";
        break;
    }
    return facts;
}

} // namespace limen::viewer
