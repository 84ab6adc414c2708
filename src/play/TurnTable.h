#pragma once

#include "play/FrameSource.h"

namespace limen::play {

/// A camera that circles a place once and looks at it.
struct TurnTableRequest {
    engine::ViewRequest centre;     ///< with scene, field of view and picture size of all frames
    std::optional<double> distance; ///< metres from the centre to the camera; none: chosen
    std::size_t frames = 240;
    double framesPerSecond = 30.0; ///< > 0; the world's time between two frames
};

/// The path of the camera around the centre.
struct TurnTableCircle {
    double distance = 0.0;  ///< metres; 0: the camera stands at the centre and turns
    double elevation = 0.0; ///< degrees above the horizon, seen from the centre
};

/// Chooses the largest circle, and then the lowest elevation, on which no wall is between camera and centre.
/// Circles steeper than 33 degrees are used only where no flatter one is free. With a `distance`, the elevation with the fewest walls in between. Without any free circle, as in a small
/// room, the camera stands at the centre.
[[nodiscard]] TurnTableCircle chooseCircle(const world::World& world, world::SpaceIndex root,
                                           const Vec3& centre, std::optional<double> distance);

/// The camera at a share 0..1 of the turn. It begins behind the heading of `centre` and turns clockwise.
[[nodiscard]] engine::Camera turnTableCamera(const engine::Camera& centre, const TurnTableCircle& circle,
                                             double share);

/// The space of a camera around a centre in the space `root`. In a dungeon it is reached through portals.
/// Elsewhere the position decides, so that a camera can circle the building that contains the centre.
[[nodiscard]] world::SpaceIndex turnTableRoot(const world::World& world, world::SpaceIndex root,
                                              const Vec3& centre, const Vec3& eye);

/// Loads the blocks around the centre. Errors: the session's; an unknown place.
[[nodiscard]] Result<std::unique_ptr<FrameSource>> openTurnTable(engine::Session& session,
                                                                 TurnTableRequest request);

} // namespace limen::play
