#pragma once

#include "engine/Session.h"
#include "frame/SceneUpload.h"
#include "viewer/pages/Pages.h"

#include <atomic>
#include <functional>
#include <future>

namespace limen::viewer {

/// A world to open.
struct OpenRequest {
    std::string directory; ///< empty: the built-in world
    engine::SessionOptions options;
    /// The first view, from the world's files. Called on another thread.
    std::function<Result<engine::ViewRequest>(const engine::WorldSource&)> start;
};

/// A world that is ready to be drawn.
struct OpenedWorld {
    std::unique_ptr<engine::Session> session;
    engine::FrameRequest start;
};

/// Opens a world beside the one on the screen: files and landblocks are read on another thread, the scene is
/// uploaded in slices. The device must outlive it. The destructor cancels and waits for the thread.
class WorldOpening {
public:
    WorldOpening(gpu::Device& device, OpenRequest request);
    ~WorldOpening();
    WorldOpening(const WorldOpening&) = delete;
    WorldOpening& operator=(const WorldOpening&) = delete;

    /// Does one frame's share of the work, with the GL context current. True: the world is ready. Errors: those
    /// of the files, of the first view, of loading, of the driver.
    [[nodiscard]] Result<bool> step();
    /// Waits for the thread's work, at most `seconds`.
    void wait(double seconds) const;
    /// Requires that `step` returned true.
    [[nodiscard]] OpenedWorld take();
    [[nodiscard]] LoadingFacts facts() const;
    [[nodiscard]] const std::string& directory() const { return request_.directory; }

    /// Ends the work as soon as possible. Nothing blocks.
    void cancel();
    /// True: the destructor does not wait.
    [[nodiscard]] bool isIdle() const;

private:
    struct Found {
        std::shared_ptr<const engine::WorldSource> source;
        engine::ViewRequest view;
    };
    struct Read {
        std::unique_ptr<engine::PartPlanner> planner;
        std::unique_ptr<gpu::StagedScene> scene;
    };
    enum class Phase { Files, Renderer, Blocks, Upload, Ready };

    [[nodiscard]] Result<Found> find();
    [[nodiscard]] Result<Read> read() const;
    [[nodiscard]] Result<void> advance();
    [[nodiscard]] Result<void> beginUpload();
    [[nodiscard]] Result<void> finish();

    gpu::Device& device_;
    const OpenRequest request_;
    Phase phase_ = Phase::Files;
    std::unique_ptr<world::LoadProgress> progress_ = std::make_unique<world::LoadProgress>();
    std::atomic<std::size_t> searched_{0}, toSearch_{0}; ///< steps of the search for places
    std::unique_ptr<engine::Session> session_;
    engine::ViewRequest view_;
    engine::FrameRequest start_;
    std::unique_ptr<engine::PartPlanner> planner_;
    std::shared_ptr<const frame::SceneUpload> arrays_; ///< of the scene that is being uploaded
    std::size_t bytes_ = 0, sent_ = 0;                 ///< of the upload
    std::future<Result<Found>> finding_;
    std::future<Result<Read>> reading_; ///< last: its work refers to the other members
};

} // namespace limen::viewer
