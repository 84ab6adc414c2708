#pragma once

#include "engine/Background.h"
#include "engine/Session.h"

namespace limen::engine {

/// Streams the parts of a session's world that come near a moving eye, as the session's options say at the time: they are read and made ready on other threads, uploaded in
/// slices, and shown in one frame, in which eye, root and body follow as they do for what is loaded at once.
class SessionStream final : public Residency, private StreamTasks {
public:
    /// Bytes that a frame uploads; of array and texel memory. A fixed share, not a time, so that what a frame does follows from what was
    /// read alone.
    static constexpr std::size_t kBytesPerFrame = std::size_t{256} << 10;
    /// While an eye waits to go elsewhere: nobody is there for whom frames are to be even, and somebody waits.
    static constexpr std::size_t kBytesWhileWaiting = std::size_t{4} << 20;

    /// The session must outlive it, and has loaded a part of the world.
    explicit SessionStream(Session& session);

    bool follow(const Vec3& eye, world::SpaceIndex& root, play::Walk* walk) override;
    [[nodiscard]] Passage open(dat::BlockCoord centre) override;
    /// What was shown anew in the last frame.
    [[nodiscard]] const std::optional<StreamTarget>& shown() const { return justShown_; }
    /// Whether the last frame's open was refused.
    [[nodiscard]] bool hasRefused() const { return hasRefused_; }
    [[nodiscard]] const Streamer& streamer() const { return streamer_; }
    /// As Streamer::takeFault.
    [[nodiscard]] std::string takeFault() { return streamer_.takeFault(); }

private:
    /// Read, and ready to be uploaded.
    struct Part {
        std::shared_ptr<LoadedWorld> loaded;
        std::unique_ptr<gpu::StagedScene> scene;
        std::shared_ptr<const frame::SceneUpload> arrays; ///< of the scene that is being uploaded
    };
    [[nodiscard]] static Result<Part> read(const Session& session, const StreamTarget& target,
                                           const gpu::RendererOptions& options,
                                           const gpu::SceneState& before);

    /// True if another part is shown from now on.
    bool step(const StreamEye& eye);

    void beginToRead(const StreamTarget& target) override;
    [[nodiscard]] std::optional<Result<void>> pollRead() override;
    [[nodiscard]] Result<void> beginToUpload() override;
    [[nodiscard]] Result<bool> advance() override;
    void drop() override;
    void show() override;

    Session& session_;
    Streamer streamer_{*this};
    std::future<Result<Part>> reading_;
    Part coming_;
    bool isUploading_ = false;
    play::Walk* walk_ = nullptr; ///< during follow
    std::optional<StreamTarget> justShown_;
    bool hasRefused_ = false;
    std::size_t bytesPerFrame_ = kBytesPerFrame;
    Background background_; ///< last: what it does refers to the others
};

} // namespace limen::engine
