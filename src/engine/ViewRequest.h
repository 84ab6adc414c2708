#pragma once

#include "check/View.h"
#include "core/Error.h"
#include "engine/Camera.h"
#include "engine/SceneState.h"
#include "world/Places.h"

#include <optional>
#include <string>
#include <vector>

// A frame in the terms of a user or a script, before any part of the world is loaded. FrameRequest.h has the same frame in the
// terms of a loaded world.
namespace limen::engine {

/// The rule that finds the space of an eye or of a body.
struct RootChoice {
    enum class Rule { Auto, Outside, Cell } rule = Rule::Auto;
    dat::RecordId cell = 0; ///< of Rule::Cell
};

/// The player's body.
struct BodyRequest {
    Vec3 feet{0.0};   ///< global
    double yaw = 0.0; ///< degrees; the direction that it faces
    RootChoice root;  ///< of the space that its middle is in
    double opacity = 1.0;
    double speed = 0.0;  ///< metres a second; 0: it stands
    double metres = 0.0; ///< walked so far; selects the phase of the stride
};

/// SceneState with names in place of indices.
struct SceneRequest {
    double time = 0.5;
    std::string day; ///< a day group's number or name (engine/DayGroup.h); empty: the first
    Weather weather = Weather::Clear;
    double seconds = 0.0;
    std::optional<double> doors;
    std::vector<check::View::DoorState> eachDoor; ///< by name; other doors keep their resting openness
    std::optional<BodyRequest> body;
};

/// How high above the ground a camera is placed that map coordinates give, in metres.
inline constexpr double kEyeHeight = 1.7;

struct ViewRequest {
    std::string place;                ///< a name of world.json; empty: the position below counts
    Vec3 eye{0.0};                    ///< global
    bool isOnGround = false;          ///< the eye's height is the ground's plus kEyeHeight
    std::optional<double> yaw, pitch; ///< degrees; none: the place's own, else 0
    double fov = 60.0;                ///< vertical, degrees
    PixelSize size;
    std::optional<RootChoice> root; ///< none: the place's own, else Auto
    std::optional<Vec3> player;     ///< global; none: at the eye
    SceneRequest scene;
};

/// The request with the named place's position, heading and root filled in where the request leaves them open; `place` is then
/// empty. Errors: NotFound for a name that the world does not have (the message lists some that it has).
[[nodiscard]] Result<ViewRequest> resolvePlace(ViewRequest request, const world::WorldFile& file);

/// A request at a named place.
[[nodiscard]] ViewRequest requestAt(const world::Place& place);

/// The landblock to load for a request: the root cell's, else the eye's. Requires an empty `place`.
[[nodiscard]] dat::BlockCoord centreOf(const ViewRequest& request);

/// The place a world is first shown from: its start, else the first of its tour, else its first place, else null.
[[nodiscard]] const world::Place* firstPlace(const world::WorldFile& file);

} // namespace limen::engine
