#pragma once

#include "dat/Ids.h"
#include "world/World.h"

namespace limen::engine {

class play::Walk;

/// Whether an eye may go to another part of the world.
enum class Passage : std::uint8_t {
    Open,   ///< it is shown
    Coming, ///< not yet
    Refused ///< it cannot be loaded
};

/// What sees to it that what is around a moving eye is loaded.
class Residency {
public:
    virtual ~Residency() = default;
    /// Once a frame. True if another part of the world is shown from now on: then `root`, the space the eye is in, is translated.
    /// `walk`: null, or the body that goes with the eye.
    virtual bool follow(const Vec3& eye, world::SpaceIndex& root, play::Walk* walk) = 0;
    /// Once a frame instead, as long as an eye waits to go to the part of the world around `centre`.
    [[nodiscard]] virtual Passage open(dat::BlockCoord centre) = 0;
};

} // namespace limen::engine
