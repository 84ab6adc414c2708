#pragma once

#include "engine/Session.h"
#include "engine/stream/Background.h"
#include "motion/ChaseCamera.h"
#include "motion/Detour.h"
#include "motion/DoorUse.h"

#include <future>

namespace limen::play {

/// The player's input to a walking body for one frame.
struct WalkInput {
    double forward = 0.0, right = 0.0; ///< -1..1 each
    bool run = false, jump = false;
    double seconds = 0.0; ///< since the last frame
};

/// A body that walks through the loaded world, with the eye in first or third person. A thread of its own
/// reads the solids around the body when it enters another landblock. The position at which they are taken
/// over does not depend on the reading time, so that a walk replays equally on any machine.
class WalkingBody {
public:
    /// Puts the body under the request's eye. Blocks until the solids around it are read. Errors: unreadable
    /// solids.
    [[nodiscard]] Result<void> begin(const engine::Session& session, const engine::FrameRequest& request);
    /// Removes the body; the eye stays.
    void end(engine::FrameRequest& request);
    [[nodiscard]] bool isOn() const { return isOn_; }

    /// Selects third person (true) or first person (false).
    void chase(bool isChased);
    [[nodiscard]] bool isChased() const { return isChased_; }
    /// Sets the third-person distance in metres, clamped to kNearest..kFarthest.
    void keepDistance(double metres);
    [[nodiscard]] double distance() const { return chaseShape_.distance; }
    static constexpr double kNearest = 1.0, kFarthest = 8.0;

    /// Moves the body, and updates eye, player, body and root of `request`. After the session has shown
    /// another part of the world, the body continues there at the same position. Requires a body. Errors: as
    /// begin's.
    [[nodiscard]] Result<void> step(const engine::Session& session, const WalkInput& input,
                                    engine::FrameRequest& request);

    /// Advances swinging doors; their leaves push the body. Requires a body.
    void passDoors(motion::DoorUse& doors, double seconds);
    /// The openness that doors reach when all swing from one openness to another; the body can block them.
    /// Requires a body.
    [[nodiscard]] double swingAllDoors(double from, double to);
    /// Reads the solids around the body in the next part. Returns true when they are ready; then the first
    /// step in that part does not block. Requires a body.
    [[nodiscard]] bool prepare(const engine::Session& session,
                               const std::shared_ptr<const engine::LoadedPart>& next);

    /// A way around obstacles from the body to a position of its feet, doors as in the last step, searched on
    /// squares of this side in metres. Requires a body.
    [[nodiscard]] motion::Detour wayAround(const Vec3& feet, double square) const;

    [[nodiscard]] const motion::BodyState& body() const { return body_; }
    /// The first-person eye.
    [[nodiscard]] motion::BodyEye head(const world::World& world) const;

private:
    /// The solids of a loaded part of the world.
    struct Surroundings {
        std::shared_ptr<const engine::LoadedPart> loaded;
        motion::Collisions collisions;
    };
    using Reading = Result<std::shared_ptr<const Surroundings>>;

    /// Surroundings that a thread is reading.
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
    /// Transfers the body's spaces from the old part to the new one.
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
    std::vector<double> doors_; ///< openness of each door in this frame
    motion::BodyState body_;
    motion::BodyShape shape_;
    double yaw_ = 0.0;                  ///< heading of the body, degrees
    double speed_ = 0.0, metres_ = 0.0; ///< as in PlayerBody
    /// Metres of the eye above its place in the head. It decays, so that the eye climbs steps smoothly.
    double lag_ = 0.0;
    bool isChased_ = false;
    motion::ChaseState chase_;
    motion::ChaseShape chaseShape_;
    std::shared_ptr<const Surroundings> around_;
    Coming coming_; ///< of the shown part
    Coming next_;   ///< of the next part
    engine::Background background_;
};

} // namespace limen::play
