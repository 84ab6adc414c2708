#pragma once

#include "cli/world/PlacedWorld.h"
#include "geometry/Vec.h"

#include <nlohmann/json_fwd.hpp>
#include <optional>

// The placed objects of a world as lines and as JSON, from a world.db or a world.json.
namespace limen::cli {

/// One object, as `limen world list` prints it.
struct PlacedLine {
    std::string id;         ///< the guid, e.g. "0x7A9B4000"; of world.json the name
    std::string type;       ///< "door", "creature", "villager"
    std::string name;       ///< of its template; empty: none
    std::string origin;     ///< the template's number, or the model
    std::uint32_t cell = 0; ///< 0: outside
    Vec3 position{0.0};     ///< global, metres
};

/// The objects that `limen world list` prints.
struct PlacedFilter {
    std::string name, type;             ///< a part of the name, a type; empty: all
    std::optional<std::uint32_t> block; ///< a landblock's number
    std::size_t limit = 0;              ///< 0: all
};

/// The objects of a world, by name, then by id. Errors: a type that does not exist; those of the database.
[[nodiscard]] Result<std::vector<PlacedLine>> listPlaced(const PlacedWorld& world,
                                                         const PlacedFilter& filter);

/// One object with its template, or one template. `id`: a guid in hexadecimal, the number of a template, or the name of
/// an object of world.json. Errors: there is none; those of the database.
[[nodiscard]] Result<nlohmann::ordered_json> describePlaced(const PlacedWorld& world, const std::string& id);

} // namespace limen::cli
