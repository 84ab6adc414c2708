#pragma once

#include "world/World.h"

namespace limen::app {

class Walk;

/// What sees to it that what is around a moving eye is loaded.
class Residency {
public:
    virtual ~Residency() = default;
    /// Once a frame. True if another part of the world is shown from now on: then `root`, the space the eye is in, is translated.
    /// `walk`: null, or the body that goes with the eye.
    virtual bool follow(const Vec3& eye, world::SpaceIndex& root, Walk* walk) = 0;
};

} // namespace limen::app
