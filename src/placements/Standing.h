#pragma once

#include "placements/Placements.h"

#include <functional>

namespace limen::placements {

/// An object that stands in the world at its start: a placed one, or one that a generator has made.
struct Standing {
    std::uint64_t id =
        0; ///< unique in the world, below 2^48: the guid, and above it the number of a made object
    std::uint32_t templateId = 0;
    Spot spot;
    bool isScattered = false;            ///< near a generator: outdoors, its height is that of the ground
    std::optional<std::int32_t> palette; ///< in place of its template's
    std::optional<float> shade;
};

/// Yields a template; null if there is none with this id. Pointers are valid for the call.
using FindTemplate = std::function<const Template*(std::uint32_t)>;

/// True if the objects of a template are drawn: it has a Setup and is neither hidden nor marked as invisible.
[[nodiscard]] bool isVisible(const Template& of);

/// The visible objects of a landblock at the start, by id. A link child stands if its parent does. A generator makes its
/// initial objects; chance is a function of its guid. Objects in containers and shops do not stand.
[[nodiscard]] std::vector<Standing> standingIn(const Landblock& landblock, const FindTemplate& find);

} // namespace limen::placements
