#pragma once

#include "dat/Ids.h"
#include "geometry/Vec.h"
#include "world/Look.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limen::check {

/// The kinds of view (src/check/README.md, `limen check`), in the order in which they run.
enum class ViewKind : std::uint8_t {
    Random,    ///< anywhere in a cell
    Outside,   ///< anywhere above the landscape
    Path,      ///< along the tour and along random walks through portals
    Sweep,     ///< through a portal, in steps down to a tenth of a millimetre
    Still,     ///< drawn twice: both pictures must be the same to the bit
    Straddle,  ///< at the planes, edges and corners of openings, from a micrometre on
    Telephoto, ///< through openings, with a field of view of a few degrees
    Wide       ///< a field of view of 150 degrees and more
};
inline constexpr std::size_t kKindCount = 8;
inline constexpr std::array<std::string_view, kKindCount> kKindNames{
    "random", "outside", "path", "sweep", "still", "straddle", "telephoto", "wide"};
/// The kinds of a check that names none: the first ones.
inline constexpr std::size_t kUsualKinds = 5;

[[nodiscard]] constexpr std::string_view nameOf(ViewKind kind) {
    return kKindNames[static_cast<std::size_t>(kind)];
}
[[nodiscard]] std::optional<ViewKind> kindNamed(std::string_view name);

/// One view that is checked, in the terms of `limen shot`.
struct View {
    ViewKind kind = ViewKind::Random;
    Vec3 eye{0.0};                           ///< global, metres
    double yaw = 0.0, pitch = 0.0;           ///< degrees: yaw 0 north, 90 east; pitch 90 straight up
    double fov = 60.0;                       ///< vertical, degrees
    std::uint32_t width = 640, height = 360; ///< pixels
    dat::RecordId root = 0;                  ///< cell of the eye; 0: outside
    double time = 0.5;                       ///< of day, 0 and 1 midnight
    double seconds = 0.0;                    ///< since the world began
    std::optional<double> doors;             ///< openness of all doors; none: each its own
    struct DoorState {
        std::string name; ///< as in the world file
        double open = 0.0;
    };
    std::vector<DoorState> eachDoor; ///< doors that differ from the world file; used without `doors`
    std::uint32_t dayGroup = 0;      ///< of the Region
    bool rain = false;
    world::Look look = world::Look::Retail;
    std::optional<Vec3> player; ///< the player's position, global; none: the eye
    /// The player's body, if it is drawn.
    struct Body {
        Vec3 feet{0.0};         ///< global
        double yaw = 0.0;       ///< compass direction that it faces, degrees
        dat::RecordId root = 0; ///< cell of its middle; 0: outside
        double opacity = 1.0;   ///< 0: not drawn
        double speed = 0.0;     ///< metres a second on foot; 0: it stands
        double metres = 0.0;    ///< walked so far
    };
    std::optional<Body> body;
    std::string about; ///< its origin, as text for reports
};

/// The landblock that `limen shot` loads around for this view: the root cell's, else the eye's.
[[nodiscard]] dat::BlockCoord centreOf(const View& view);

/// The options of `limen shot` that draw this view again, with its root. Reading the numbers back gives the
/// same bits.
[[nodiscard]] std::string shotOptions(const View& view);

} // namespace limen::check
