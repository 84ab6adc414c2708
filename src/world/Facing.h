#pragma once

#include <cstdint>

namespace limen::world {

/// How the drawn frame of a mesh turns to the eye: the modes of levels of detail
/// (docs/formats/geometry.md#levels-of-detail).
enum class Facing : std::uint8_t {
    Fixed = 0, ///< it does not turn
    Eye = 2,   ///< +y points away from the eye, without roll
    AroundX = 3,
    AroundY = 4,
    AroundZ = 5, ///< about the mesh's own z
};

} // namespace limen::world
