#pragma once

#include "dat/Ids.h"
#include "geometry/Vec.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limen::check {

/// The kinds of view (src/check/README.md), in the order they are run in.
enum class Kind : std::uint8_t {
    Random,  ///< anywhere in a cell
    Outside, ///< anywhere above the landscape
    Path,    ///< along the tour and along random walks through portals
    Sweep,   ///< through a portal, in steps down to a tenth of a millimetre
    Still    ///< drawn twice: both pictures must be the same to the bit
};
inline constexpr std::size_t kKindCount = 5;
inline constexpr std::array<std::string_view, kKindCount> kKindNames{"random", "outside", "path", "sweep",
                                                                     "still"};

[[nodiscard]] constexpr std::string_view nameOf(Kind kind) {
    return kKindNames[static_cast<std::size_t>(kind)];
}
[[nodiscard]] std::optional<Kind> kindNamed(std::string_view name);

/// One eye that is checked, in the terms of `limen shot`.
struct View {
    Kind kind = Kind::Random;
    Vec3 eye{0.0};                           ///< global, metres
    double yaw = 0.0, pitch = 0.0;           ///< degrees: yaw 0 north, 90 east; pitch 90 straight up
    double fov = 60.0;                       ///< vertical, degrees
    std::uint32_t width = 640, height = 360; ///< pixels
    dat::RecordId root = 0;                  ///< cell that the eye is in; 0: outside
    double time = 0.5;                       ///< of day, 0 and 1 midnight
    double seconds = 0.0;                    ///< since the world began
    std::optional<double> doors;             ///< how far all doors stand open; none: each as it rests
    struct DoorState {
        std::string name; ///< as in the world file
        double open = 0.0;
    };
    std::vector<DoorState> eachDoor; ///< those that do not rest; where `doors` says nothing
    std::uint32_t dayGroup = 0;      ///< of the Region's
    bool rain = false;
    std::optional<Vec3> player; ///< where the player is, global; none: at the eye
    /// The player's body, if it has one.
    struct Body {
        Vec3 feet{0.0};         ///< global
        double yaw = 0.0;       ///< it faces that way, degrees
        dat::RecordId root = 0; ///< cell that its middle is in; 0: outside
        double opacity = 1.0;   ///< 0: not seen
        double speed = 0.0;     ///< metres a second that it walks or runs; 0: it stands
        double metres = 0.0;    ///< that it has walked
    };
    std::optional<Body> body;
    std::string about; ///< where it comes from, for people
};

/// The landblock that `limen shot` loads around for this view: the root cell's, else the eye's.
[[nodiscard]] dat::BlockCoord centreOf(const View& view);

/// The options of `limen shot` that draw this view again, the root named. Numbers are written so that they are read
/// back as the very same.
[[nodiscard]] std::string shotOptions(const View& view);

} // namespace limen::check
