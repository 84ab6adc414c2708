#pragma once

#include "world/MovingEntries.h"
#include "world/block/BlockContent.h"
#include "world/texture/PictureCache.h"

#include <functional>

namespace limen::world {

/// The sources that a World is assembled from. All outlive the assembly.
struct AssemblySources {
    Records& records;
    Models& models;
    const dat::Region* region = nullptr; ///< null: the world has none
    PictureCache* pictures = nullptr;    ///< null: pictures are decoded anew
    Readings readings{};
};

/// Yields the next block; null after the last one.
using NextBlock = std::function<std::shared_ptr<const BlockContent>()>;

/// Joins blocks into a World. Requires: they come in ascending order of (x, y). Then the result depends on
/// nothing but their content, the records and `moving`. Without any block, the result holds the outside and
/// no instance.
[[nodiscard]] World assembleWorld(const AssemblySources& sources, const NextBlock& nextBlock,
                                  const MovingEntries& moving = {});

} // namespace limen::world
