#pragma once

#include "core/Assert.h"
#include "world/block/BlockContent.h"

namespace limen::world {

/// The place of an object in a World.
struct ObjectSite {
    std::uint32_t block = 0;  ///< index into World::blocks
    Vec3 blockOrigin{0.0};    ///< global, metres
    SpaceIndex space = kNone; ///< that it stands in
};

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
    /// The site of an object in that cell.
    [[nodiscard]] ObjectSite siteOf(std::uint32_t local) const { return {index, origin, spaceOf(local)}; }
};

} // namespace limen::world
