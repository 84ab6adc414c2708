#include "play/TurnTable.h"

#include "motion/Locate.h"
#include "reference/Scene.h"

#include <array>
#include <cmath>
#include <span>

namespace limen::play {
namespace {

constexpr std::array kDistances{24.0, 16.0, 11.0, 7.0, 4.5, 3.0};           ///< metres
constexpr std::array kElevations{12.0, 18.0, 25.0, 33.0, 42.0, 52.0, 62.0}; ///< degrees
constexpr std::size_t kFlatElevations = 4; ///< of these: the horizon stays in the picture or near it
constexpr int kDirections = 48;            ///< tested directions of a circle
constexpr double kMargin = 1.0;            ///< metres kept free behind the camera

/// The unit vector from the centre to the camera. `yaw`: the camera's heading, degrees.
Vec3 towardsCamera(double yaw, double elevation) {
    return -engine::basisOf({yaw, -elevation}).forward;
}

/// The number of tested directions with a surface between the centre and the camera.
int blockedDirections(const reference::Scene& scene, world::SpaceIndex root, const Vec3& centre,
                      const TurnTableCircle& circle) {
    int blocked = 0;
    for (int i = 0; i < kDirections; ++i) {
        const Vec3 direction = towardsCamera(360.0 * i / kDirections, circle.elevation);
        const double t = scene.trace(root, {centre, direction}).t;
        blocked += t < circle.distance + kMargin || std::isnan(t) ? 1 : 0;
    }
    return blocked;
}

class TurnTableFrames final : public FrameSource {
public:
    TurnTableFrames(engine::Session& session, engine::FrameRequest centre, const TurnTableRequest& request)
        : session_(session), centre_(centre), frame_(std::move(centre)), count_(request.frames),
          framesPerSecond_(request.framesPerSecond),
          circle_(chooseCircle(session.part().world, centre_.root, centre_.camera.eye, request.distance)) {}
    std::size_t count() const override { return count_; }
    Result<const engine::FrameRequest*> next() override {
        const auto frame = static_cast<double>(next_++);
        frame_.camera = turnTableCamera(centre_.camera, circle_, frame / static_cast<double>(count_));
        frame_.root =
            turnTableRoot(session_.part().world, centre_.root, centre_.camera.eye, frame_.camera.eye);
        frame_.scene.seconds = centre_.scene.seconds + frame / framesPerSecond_;
        frame_.scene.player = frame_.camera.eye;
        return &frame_;
    }

private:
    engine::Session& session_;
    const engine::FrameRequest centre_;
    engine::FrameRequest frame_;
    std::size_t count_, next_ = 0;
    double framesPerSecond_;
    TurnTableCircle circle_;
};

} // namespace

TurnTableCircle chooseCircle(const world::World& world, world::SpaceIndex root, const Vec3& centre,
                             std::optional<double> distance) {
    const reference::Scene scene(world);
    if (distance && *distance <= 0.0)
        return {};
    if (distance) {
        TurnTableCircle best{*distance, kElevations.front()};
        int fewest = kDirections + 1;
        for (const double elevation : kElevations) {
            const TurnTableCircle circle{*distance, elevation};
            if (const int blocked = blockedDirections(scene, root, centre, circle); blocked < fewest) {
                fewest = blocked;
                best = circle;
            }
        }
        return best;
    }
    const std::span all(kElevations);
    for (const auto& elevations : {all.first(kFlatElevations), all.subspan(kFlatElevations)})
        for (const double radius : kDistances)
            for (const double elevation : elevations)
                if (const TurnTableCircle circle{radius, elevation};
                    blockedDirections(scene, root, centre, circle) == 0)
                    return circle;
    return {};
}

engine::Camera turnTableCamera(const engine::Camera& centre, const TurnTableCircle& circle, double share) {
    engine::Camera camera = centre;
    camera.heading.yaw = std::remainder(centre.heading.yaw + 360.0 * share, 360.0);
    if (circle.distance <= 0.0)
        return camera;
    camera.heading.pitch = -circle.elevation;
    camera.eye = centre.eye + towardsCamera(camera.heading.yaw, circle.elevation) * circle.distance;
    return camera;
}

world::SpaceIndex turnTableRoot(const world::World& world, world::SpaceIndex root, const Vec3& centre,
                                const Vec3& eye) {
    const bool isDungeon = root != world::kOutside && !world.spaces[root].ofBuilding;
    return isDungeon ? motion::sweep(world, root, centre, eye) : motion::locate(world, eye).space;
}

Result<std::unique_ptr<FrameSource>> openTurnTable(engine::Session& session, TurnTableRequest request) {
    Result<engine::ViewRequest> centre = engine::resolvePlace(std::move(request.centre), session.source());
    if (!centre)
        return Failure(centre.error());
    if (Result<void> loaded = session.load(engine::centreOf(*centre)); !loaded)
        return Failure(loaded.error());
    Result<engine::FrameRequest> frame =
        engine::frameRequest(session.part().world, session.source().file, *centre);
    if (!frame)
        return Failure(frame.error());
    return std::make_unique<TurnTableFrames>(session, std::move(*frame), request);
}

} // namespace limen::play
