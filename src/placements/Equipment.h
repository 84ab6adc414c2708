#pragma once

#include "placements/Standing.h"

namespace limen::placements {

/// The place of a held item: a holding location of the holder's Setup, and a placement frame of the item's own Setup.
struct Grip {
    std::uint32_t location = 0, placement = 0;
    friend bool operator==(const Grip&, const Grip&) = default;
};

/// An item that an object wears or holds at the start.
struct EquippedItem {
    std::uint32_t templateId = 0;
    std::optional<std::int32_t> palette; ///< in place of its template's
    std::optional<float> shade;
    std::optional<Grip> grip; ///< none: it is worn
    friend bool operator==(const EquippedItem&, const EquippedItem&) = default;
};

/// The worn items of an object, from the skin outwards, then the held ones: at most one weapon, and one shield or weapon of
/// the left hand. Items with a probability form sets, of which one item at most is chosen; chance depends on `object`.
/// Items without a template are left out.
[[nodiscard]] std::vector<EquippedItem> equipmentOf(const Template& of, std::uint64_t object,
                                                    const FindTemplate& find);

} // namespace limen::placements
