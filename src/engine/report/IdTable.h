#pragma once

#include "world/DynamicState.h"
#include "world/World.h"

#include <string>
#include <vector>

namespace limen::engine {

/// The meaning of an id of the id image, in the terms of frame.json.
struct IdMeaning {
    std::string space;         ///< "outside", "0x%08X", or "none" for void
    std::string kind;          ///< "shell", "terrain", ..., "sky", "void"
    std::string record;        ///< "0x%08X"
    std::string object;        ///< the object's identity, 16 hexadecimal digits; empty for sky and void
    std::uint32_t polygon = 0; ///< the polygon's id in the record
    bool operator==(const IdMeaning&) const = default;
};

inline constexpr std::uint32_t kVoidPixel = 0, kSkyPixel = 1;

/// "outside", the cell's id as "0x%08X", or "none" for an index beyond the world's spaces.
[[nodiscard]] std::string spaceName(const world::World& world, world::SpaceIndex space);

/// Looks up the ids of one world's pictures. The world must outlive it.
class IdTable {
public:
    explicit IdTable(const world::World& world);
    /// An id that belongs to no instance has the kind "unknown" and the space "none". Dynamic instances are
    /// in the space that `dynamics` gives; particles have ids in `dynamics` only.
    [[nodiscard]] IdMeaning meaning(std::uint32_t id, const world::DynamicState& dynamics = {}) const;
    /// The instance that an id belongs to, from World::instances or World::movingParts; null: none.
    [[nodiscard]] const world::Instance* instance(std::uint32_t id) const;

private:
    const world::World& world_;
    std::vector<const world::Instance*> byId_; ///< those with polygons, ascending by idBase
};

} // namespace limen::engine
