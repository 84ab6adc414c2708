#pragma once

#include "world/World.h"

namespace limen::world {

/// The index of a level in World::levels; kNone if it is drawn at every distance. Parts of one object are
/// added one after another and share their entry.
[[nodiscard]] inline std::uint32_t addLevel(const Level& level, World& world) {
    if (level.range.isEndless())
        return kNone;
    if (world.levels.empty() || world.levels.back() != level)
        world.levels.push_back(level);
    return static_cast<std::uint32_t>(world.levels.size() - 1);
}

} // namespace limen::world
