#pragma once

#include "check/View.h"
#include "core/Error.h"
#include "engine/Camera.h"
#include "engine/DayGroup.h"
#include "engine/SceneState.h"
#include "world/Places.h"

#include <optional>
#include <string>
#include <vector>

// A frame as a user or a script describes it, before any part of the world is loaded: by names and record
// ids. FrameRequest.h has the same frame with the indices of a loaded part.
namespace limen::engine {

struct WorldSource;

/// The rule by which the space of an eye or of a body is found. Auto: from the position.
struct RootChoice {
    enum class Rule { Auto, Outside, Cell } rule = Rule::Auto;
    dat::RecordId cell = 0; ///< of Rule::Cell
};

/// The player's body.
struct BodyRequest {
    Vec3 feet{0.0};   ///< global
    double yaw = 0.0; ///< degrees; the direction the body faces
    RootChoice root;  ///< finds the space of the body's centre
    double opacity = 1.0;
    double speed = 0.0;  ///< metres a second; 0: standing
    double metres = 0.0; ///< distance walked so far; selects the phase of the stride
};

/// SceneState with names in place of indices.
struct SceneRequest {
    double time = 0.5;
    DayChoice day;
    Weather weather = Weather::Clear;
    Look look = Look::Retail;
    double seconds = 0.0;
    std::optional<double> doors;
    std::vector<check::View::DoorState> eachDoor; ///< by name; other doors keep their initial openness
    std::optional<BodyRequest> body;
};

/// Height above the ground of a camera at map coordinates, in metres.
inline constexpr double kEyeHeight = 1.7;

/// A frame by names: the content of `limen shot`'s options.
struct ViewRequest {
    bool isAtStart = false;           ///< at firstPlace; `place` and `eye` do not apply
    std::string place;                ///< a name of world.json; empty: `eye` applies
    Vec3 eye{0.0};                    ///< global, metres
    bool isOnGround = false;          ///< replaces the eye's height by that of the ground plus kEyeHeight
    std::optional<double> yaw, pitch; ///< degrees; none: those of the place, else 0
    double fov = 60.0;                ///< vertical, degrees
    PixelSize size;
    std::optional<RootChoice> root; ///< none: the place's, else Auto
    std::optional<Vec3> player;     ///< global, metres; none: at the eye
    SceneRequest scene;
};

/// Replaces the start or the name of a place by its position, and fills in heading and root if the request has
/// none. `place` is then empty, and `isAtStart` false. A name matches exactly, else without regard to case,
/// spaces and hyphens. Errors: NotFound for an unknown name; the message lists similar ones. NotFound for the
/// start of a world without places.
[[nodiscard]] Result<ViewRequest> resolvePlace(ViewRequest request, const world::WorldFile& file);

/// A request at a named place.
[[nodiscard]] ViewRequest requestAt(const world::Place& place);

/// The landblock to load for a request: that of the root cell, else that of the eye. Requires a resolved place.
[[nodiscard]] dat::BlockCoord centreOf(const ViewRequest& request);

/// The first viewpoint in a world: its start, else the first of its tour, else its first place. Null: the
/// world has none.
[[nodiscard]] const world::Place* firstPlace(const world::WorldFile& file);

/// A viewpoint that a program keeps from one run to the next, for one directory of dats.
struct RememberedPlace {
    Vec3 eye{0.0};                 ///< global, metres
    double yaw = 0.0, pitch = 0.0; ///< degrees
    dat::RecordId cell = 0;        ///< 0: outside
};
/// The request of the first view: the remembered place if this world still has its cell (or, outside, its
/// landblock), else firstPlace. None: the world has no viewpoint.
[[nodiscard]] std::optional<ViewRequest> firstView(const WorldSource& source,
                                                   const std::optional<RememberedPlace>& remembered = {});

} // namespace limen::engine
