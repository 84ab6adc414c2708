#pragma once

#include "cli/Parse.h"

#include <optional>
#include <variant>

namespace limen::cli {

/// A place by its name: one of `world.json`, or one found in the data.
struct PlaceName {
    std::string name;
};

/// A place by its coordinates.
struct PlacePosition {
    Vec3 eye{0.0};               ///< global; z is ignored if `onGround`
    bool onGround = false;       ///< map coordinates: the eye is above the ground there
    std::optional<double> yaw;   ///< degrees, if the notation contains a heading
    std::optional<double> pitch; ///< degrees
    engine::RootChoice root;     ///< Auto unless the notation names a cell or landcell
};

using PlaceNotation = std::variant<PlaceName, PlacePosition>;

/// Parses every notation of a place except that of the option --eye:
///   cottage.cellar                       a name; with blanks if it begins with a letter: Glenden Wood
///   A9B4.12,34,5 or 0xA9B4.12,34,5       landblock and local metres; with eight digits also the cell
///   0xA9B40031 [x y z] w x y z           retail: cell or landcell, local metres, optional unit quaternion
///   42.1N, 33.6E                         map coordinates, on the ground
/// Except for map coordinates, the position is exactly the eye's. Errors: another notation; a number that is
/// not finite; a landblock beyond 0xFE; a quaternion of length 0; coordinates beyond the map.
[[nodiscard]] Result<PlaceNotation> parsePlace(std::string_view option, std::string_view text);

} // namespace limen::cli
