#pragma once

#include "engine/Session.h"
#include "engine/stream/Background.h"
#include "engine/stream/Streamer.h"

namespace limen::engine {

/// Streams the part of the world around a moving eye, with the session's current loading options. It carries
/// out the commands of a Streamer: parts are read and staged on other threads, uploaded in slices, and shown
/// in one frame. No call blocks.
class StreamedResidency final : public Residency {
public:
    /// Upload budget of a frame in bytes. It is a size and not a time, so that a frame's work depends on the
    /// data alone.
    static constexpr std::size_t kBytesPerFrame = std::size_t{256} << 10;
    /// Upload budget during a teleport: throughput matters more than frame pacing.
    static constexpr std::size_t kBytesWhileWaiting = std::size_t{4} << 20;

    /// Requires a session with a loaded part. The session must outlive it.
    explicit StreamedResidency(Session& session);

    [[nodiscard]] std::shared_ptr<const LoadedPart> follow(const Vec3& eye, world::SpaceIndex root) override;
    [[nodiscard]] bool isPatient() const override { return true; }
    [[nodiscard]] bool show() override;
    [[nodiscard]] Passage open(dat::BlockCoord centre) override;

    /// The part that the last frame switched to; none: the part did not change.
    [[nodiscard]] const std::optional<PartTarget>& shown() const { return justShown_; }
    /// Whether the last frame's `open` was refused.
    [[nodiscard]] bool hasRefused() const { return hasRefused_; }
    [[nodiscard]] const Streamer& streamer() const { return streamer_; }
    /// See Streamer::takeFault.
    [[nodiscard]] std::string takeFault() { return streamer_.takeFault(); }

private:
    /// A part that was read and staged for the upload.
    struct Coming {
        std::unique_ptr<PartPlanner> planner;
        std::unique_ptr<gpu::StagedScene> scene;
        std::shared_ptr<const frame::SceneUpload> arrays; ///< of the scene that is being uploaded
    };
    [[nodiscard]] static Result<Coming> read(const Session& session, const PartTarget& target,
                                             const gpu::RendererOptions& options,
                                             const gpu::SceneState& before);

    /// Does one frame's share of the work. True: the coming part is uploaded and offered.
    bool step(const StreamEye& eye);
    [[nodiscard]] StreamProgress progress(std::size_t bytes);
    void carryOut(StreamCommand command);
    void beginToRead(const PartTarget& target);
    void beginToUpload();
    /// Releases the part that has come, on another thread.
    void release();
    void drop();

    Session& session_;
    Streamer streamer_;
    std::future<Result<Coming>> reading_;
    Coming coming_;
    std::optional<Error> uploadError_; ///< of the start of an upload; the next frame reports it
    bool isUploading_ = false, isOffered_ = false;
    std::optional<PartTarget> justShown_;
    bool hasRefused_ = false;
    Background background_; ///< last, because its work refers to the other members
};

} // namespace limen::engine
