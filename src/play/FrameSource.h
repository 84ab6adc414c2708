#pragma once

#include "play/PathWalk.h"
#include "play/Play.h"
#include "play/WalkRecord.h"

#include <memory>

// Frames one after the other, whatever is done with them: a camera on a path, or a walk played again.
namespace limen::play {

class FrameSource {
public:
    virtual ~FrameSource() = default;
    [[nodiscard]] virtual std::size_t count() const = 0;
    /// The next frame's eye. It must be drawn before the next call.
    [[nodiscard]] virtual Result<const engine::FrameRequest*> next() = 0;
    /// The first frame that came out otherwise than when it was recorded, of those that were drawn; none: nullopt.
    [[nodiscard]] virtual std::optional<std::size_t> firstDifference() { return {}; }
};

/// Loads what a walk's record says, when it says so.
class RecordedResidency final : public engine::Residency {
public:
    explicit RecordedResidency(engine::Session& session) : session_(session) {}
    /// What becomes of the next frame.
    void goOn(const RecordedFrame& frame) {
        next_ = frame.shown;
        isRefused_ = frame.isRefused;
    }
    [[nodiscard]] std::shared_ptr<const engine::LoadedPart> follow(const Vec3& eye,
                                                                   world::SpaceIndex root) override;
    [[nodiscard]] bool isPatient() const override { return false; }
    [[nodiscard]] bool show() override;
    [[nodiscard]] engine::Passage open(dat::BlockCoord centre) override;

private:
    bool readNext();

    engine::Session& session_;
    std::optional<engine::PartTarget> next_;
    std::unique_ptr<engine::PartPlanner> offered_;
    bool isRefused_ = false;
};

/// A walk, played again in the session's world. One that was streamed is loaded as it was then, whatever the session's options.
class ReplayedFrames final : public FrameSource {
public:
    /// Loads what is around the beginning. Errors: the session's; a beginning that is nowhere.
    [[nodiscard]] static Result<std::unique_ptr<ReplayedFrames>>
    open(engine::Session& session, WalkRecord record, const engine::ViewRequest& start);

    std::size_t count() const override { return record_.frames.size(); }
    Result<const engine::FrameRequest*> next() override;
    std::optional<std::size_t> firstDifference() override {
        compareLast();
        return difference_;
    }

private:
    ReplayedFrames(engine::Session& session, engine::FrameRequest start, WalkRecord record)
        : session_(session), residency_(session),
          play_(session, std::move(start), record.streamed ? &residency_ : nullptr),
          record_(std::move(record)) {}
    void compareLast();

    engine::Session& session_;
    RecordedResidency residency_;
    Play play_;
    WalkRecord record_;
    std::size_t next_ = 0;
    std::optional<std::size_t> difference_;
};

/// Frames to open: a path, or a recorded walk in place of it.
struct FramesRequest {
    PathRequest path;
    std::vector<engine::ViewRequest> points; ///< of the path
    std::optional<WalkRecord> walk;
    engine::ViewRequest walkStart; ///< the beginning of the walk
};
/// Errors: the session's; a place that is nowhere.
[[nodiscard]] Result<std::unique_ptr<FrameSource>> openFrames(engine::Session& session,
                                                              FramesRequest request);

/// What is to be said of a walk that came out otherwise; empty if it did not.
[[nodiscard]] std::string differenceLine(FrameSource& frames);

} // namespace limen::play
