#pragma once

#include "play/PathWalk.h"
#include "play/Play.h"
#include "play/WalkRecord.h"

#include <memory>

// A sequence of frames, from a camera path or a replayed walk, for any consumer.
namespace limen::play {

class FrameSource {
public:
    virtual ~FrameSource() = default;
    [[nodiscard]] virtual std::size_t count() const = 0;
    /// The request of the next frame. The caller must draw it before the next call.
    [[nodiscard]] virtual Result<const engine::FrameRequest*> next() = 0;
    /// The first drawn frame that differs from the recording; nullopt if all agree.
    [[nodiscard]] virtual std::optional<std::size_t> firstDifference() { return {}; }
};

/// Loads the parts that a walk's record names, in the recorded frames.
class RecordedResidency final : public engine::Residency {
public:
    explicit RecordedResidency(engine::Session& session) : session_(session) {}
    /// Sets the recorded residency of the next frame.
    void setNext(const RecordedFrame& frame) {
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

/// Replays a walk in the session's world. A streamed walk loads the recorded parts; of the session's load
/// options only the zones and the readings apply.
class ReplayedFrames final : public FrameSource {
public:
    /// Loads the blocks around the start. Errors: the session's; a start that no place matches.
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

/// The frames to open: a recorded walk if there is one, else a path.
struct FramesRequest {
    PathRequest path;
    std::vector<engine::ViewRequest> points; ///< way points of the path
    std::optional<WalkRecord> walk;
    engine::ViewRequest walkStart; ///< the first view of the walk
};
/// Errors: the session's; an unknown place.
[[nodiscard]] Result<std::unique_ptr<FrameSource>> openFrames(engine::Session& session,
                                                              FramesRequest request);

/// A message that names the first differing frame of a replay; empty if all agree.
[[nodiscard]] std::string differenceLine(FrameSource& frames);

} // namespace limen::play
