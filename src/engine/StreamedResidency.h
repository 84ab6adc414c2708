#pragma once

#include "engine/Background.h"
#include "engine/Session.h"
#include "engine/Streamer.h"

namespace limen::engine {

/// Streams the parts of a session's world that come near a moving eye, as the session's options say at the time. Parts are read and
/// staged on other threads, uploaded in slices, and shown in one frame. No call blocks.
class StreamedResidency final : public Residency {
public:
    /// Upload budget of a frame in bytes. A fixed amount, not a time, so that a frame's work follows from the data alone.
    static constexpr std::size_t kBytesPerFrame = std::size_t{256} << 10;
    /// Upload budget during a teleport: throughput matters more than frame pacing.
    static constexpr std::size_t kBytesWhileWaiting = std::size_t{4} << 20;

    /// The session must outlive it and must have loaded a part of the world.
    explicit StreamedResidency(Session& session);

    [[nodiscard]] std::shared_ptr<const LoadedPart> follow(const Vec3& eye, world::SpaceIndex root) override;
    [[nodiscard]] bool isPatient() const override { return true; }
    [[nodiscard]] bool show() override;
    [[nodiscard]] Passage open(dat::BlockCoord centre) override;

    /// The part that the last frame began to show; none: it showed the same as before.
    [[nodiscard]] const std::optional<PartTarget>& shown() const { return justShown_; }
    /// Whether the last frame's `open` was refused.
    [[nodiscard]] bool hasRefused() const { return hasRefused_; }
    [[nodiscard]] const Streamer& streamer() const { return streamer_; }
    /// As Streamer::takeFault.
    [[nodiscard]] std::string takeFault() { return streamer_.takeFault(); }

private:
    /// Read, and staged for the upload.
    struct Coming {
        std::unique_ptr<PartPlanner> planner;
        std::unique_ptr<gpu::StagedScene> scene;
        std::shared_ptr<const frame::SceneUpload> arrays; ///< of the scene that is being uploaded
    };
    [[nodiscard]] static Result<Coming> read(const Session& session, const PartTarget& target,
                                             const gpu::RendererOptions& options,
                                             const gpu::SceneState& before);

    /// One frame's share of the work. True if the coming part is uploaded.
    bool step(const StreamEye& eye);
    [[nodiscard]] StreamProgress progress(std::size_t bytes);
    void carryOut(StreamCommand command);
    void beginToRead(const PartTarget& target);
    void beginToUpload();
    void drop();

    Session& session_;
    Streamer streamer_;
    std::future<Result<Coming>> reading_;
    Coming coming_;
    std::optional<Error> uploadError_; ///< of beginning an upload; reported in the next frame
    bool isUploading_ = false, isOffered_ = false;
    std::optional<PartTarget> justShown_;
    bool hasRefused_ = false;
    Background background_; ///< last: its work refers to the others
};

} // namespace limen::engine
