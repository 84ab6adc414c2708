#pragma once

#include "world/DynamicState.h"
#include "world/World.h"

#include <string>
#include <vector>

namespace limen::engine {

/// What an id of the id image stands for, in the words of frame.json.
struct IdMeaning {
    std::string space;         ///< "outside", "0x%08X", or "none" for void
    std::string kind;          ///< "shell", "terrain", ..., "sky", "void"
    std::string record;        ///< "0x%08X"
    std::string object;        ///< the object's identity, sixteen hexadecimal digits; empty for sky and void
    std::uint32_t polygon = 0; ///< its id in the record
    bool operator==(const IdMeaning&) const = default;
};

inline constexpr std::uint32_t kVoidPixel = 0, kSkyPixel = 1;

/// "outside" or "0x%08X".
[[nodiscard]] std::string spaceName(const world::World& world, world::SpaceIndex space);

/// Looks ids of one world's pictures up. The world must outlive it.
class IdTable {
public:
    explicit IdTable(const world::World& world);
    /// An id that no instance has is told as kind "unknown", space "none". What moves is placed where `moment` says.
    [[nodiscard]] IdMeaning meaning(std::uint32_t id, const world::DynamicState& dynamics = {}) const;
    /// The instance an id belongs to: one of World::instances or of World::movingParts, or null.
    [[nodiscard]] const world::Instance* instance(std::uint32_t id) const;

private:
    const world::World& world_;
    std::vector<const world::Instance*> byId_; ///< those with polygons, ascending by idBase
};

} // namespace limen::engine
