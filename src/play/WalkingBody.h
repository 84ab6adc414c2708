#pragma once

#include "engine/Background.h"
#include "engine/Session.h"
#include "motion/ChaseCamera.h"
#include "motion/DoorUse.h"

#include <future>

namespace limen::play {

/// What the hands ask of a walking body during one frame.
struct WalkInput {
    double forward = 0.0, right = 0.0; ///< -1..1 each
    bool run = false, jump = false;
    double seconds = 0.0; ///< since the last frame
};

/// A body that walks through what a session has loaded; the eye is in its head, or follows behind. What it bumps into is read anew
/// when it comes into another landblock, by a thread of its own, and taken at a place that does not depend on how long that takes.
class WalkingBody {
public:
    /// Puts the body under an eye. Waits for what is around it to be read. Errors: that cannot be.
    [[nodiscard]] Result<void> begin(const engine::Session& session, const engine::FrameRequest& request);
    /// No body any more; the eye stays where it is.
    void end(engine::FrameRequest& request);
    [[nodiscard]] bool isOn() const { return isOn_; }

    /// Whether the eye is to be behind the body.
    void chase(bool isChased);
    [[nodiscard]] bool isChased() const { return isChased_; }
    /// How far, metres, within kNearest and kFarthest.
    void keepDistance(double metres);
    [[nodiscard]] double distance() const { return chaseShape_.distance; }
    static constexpr double kNearest = 1.0, kFarthest = 8.0;

    /// Moves the body, and eye, player, body and root of `eye` with it. When the session has loaded another part of the world it is there as it
    /// was here. Requires a body. Errors: as begin's.
    [[nodiscard]] Result<void> step(const engine::Session& session, const WalkInput& input,
                                    engine::FrameRequest& request);

    /// Doors swing for a while, and push the body out of their way. Requires a body.
    void passDoors(motion::DoorUse& doors, double seconds);
    /// How far all doors come that swing alike from one openness to another. Requires a body.
    [[nodiscard]] double swingAllDoors(double from, double to);
    /// Reads what is around the body in the part of the world that is shown next. True when that is done: then the step after it is
    /// shown does not wait. Requires a body.
    [[nodiscard]] bool prepare(const engine::Session& session,
                               const std::shared_ptr<const engine::LoadedPart>& next);

    [[nodiscard]] const motion::BodyState& body() const { return body_; }
    /// Where its eyes would be.
    [[nodiscard]] motion::BodyEye head(const world::World& world) const;

private:
    /// The solids of a part of the world that is loaded.
    struct Surroundings {
        std::shared_ptr<const engine::LoadedPart> loaded;
        motion::Collisions collisions;
    };
    using Reading = Result<std::shared_ptr<const Surroundings>>;

    /// Surroundings that are being read.
    struct Coming {
        std::shared_ptr<const engine::LoadedPart> loaded;
        dat::BlockCoord centre;
        std::future<Reading> reading;
        [[nodiscard]] bool isOf(const std::shared_ptr<const engine::LoadedPart>& part,
                                dat::BlockCoord block) const {
            return reading.valid() && loaded == part && centre == block;
        }
    };

    [[nodiscard]] Coming beginToRead(const engine::Session& session,
                                     std::shared_ptr<const engine::LoadedPart> loaded,
                                     dat::BlockCoord centre);
    [[nodiscard]] static Reading read(const std::shared_ptr<const engine::WorldSource>& source,
                                      std::shared_ptr<const engine::LoadedPart> loaded,
                                      dat::BlockCoord centre);
    void drop();
    /// Into the world that is loaded now, from one that was.
    void follow(const engine::LoadedPart& before, const engine::LoadedPart& now);
    [[nodiscard]] Result<void> keepSurroundings(const engine::Session& session);
    [[nodiscard]] dat::BlockCoord blockOfBody(const engine::LoadedPart& loaded) const;
    [[nodiscard]] Result<void> takeSurroundings(const engine::Session& session, dat::BlockCoord centre);
    void readDoors(const world::World& world, const engine::FrameRequest& request);
    void smooth(double fellOrRose, double seconds);
    void face(const WalkInput& input, double seconds, double yaw);
    void stride(const WalkInput& input, const Vec3& from);
    void carryEye(const engine::Session& session, double seconds, engine::FrameRequest& request);

    bool isOn_ = false;
    std::vector<double> doors_; ///< how far each is open in this frame
    motion::BodyState body_;
    motion::BodyShape shape_;
    double yaw_ = 0.0;                  ///< where the body faces
    double speed_ = 0.0, metres_ = 0.0; ///< as in PlayerBody
    double lag_ = 0.0; ///< metres that the eye is still above where it belongs: it climbs steps smoothly
    bool isChased_ = false;
    motion::ChaseState chase_;
    motion::ChaseShape chaseShape_;
    std::shared_ptr<const Surroundings> around_;
    Coming coming_; ///< of the part that is shown
    Coming next_;   ///< of the part that is shown next
    engine::Background background_;
};

} // namespace limen::play
