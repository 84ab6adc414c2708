#pragma once

#include "core/Assert.h"
#include "world/block/BlockContent.h"

namespace limen::world {

/// A block while it joins a World: its content, and the offsets that make its indices and positions global.
struct JoiningBlock {
    const BlockContent& content;
    std::uint32_t index = 0;   ///< into World::blocks
    SpaceIndex firstSpace = 0; ///< of its first cell
    Vec3 origin{0.0};          ///< global, metres

    /// The space of one of its cells, of kOutdoorSpace or of kNone.
    [[nodiscard]] SpaceIndex spaceOf(std::uint32_t local) const {
        if (local == kOutdoorSpace)
            return kOutside;
        if (local == kNone)
            return kNone;
        LIMEN_ASSERT(local < content.cells.size(), "a cell of this block");
        return firstSpace + local;
    }
};

} // namespace limen::world
