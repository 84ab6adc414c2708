#pragma once

#include "placements/Standing.h"
#include "placements/WorldDb.h"
#include "world/Loader.h"
#include "world/Places.h"

#include <functional>
#include <map>
#include <mutex>

namespace limen::engine {

/// A visible object that a search found.
struct FoundObject {
    std::uint32_t guid = 0;
    std::string name;       ///< of its template
    std::string type;       ///< for people: "door"
    Vec3 position{0.0};     ///< global, metres
    dat::RecordId cell = 0; ///< 0: outdoors
    friend bool operator==(const FoundObject&, const FoundObject&) = default;
};

/// The name of a placed object without its guid, as people call it.
[[nodiscard]] std::string nameWithoutGuid(const std::string& name);

/// The placed objects of an open world.db, as entries for the loader. Safe on several threads.
class PlacedObjects {
public:
    explicit PlacedObjects(placements::WorldDb database) : database_(std::move(database)) {}

    /// The entries of the blocks that a load around `centre` reads with everything. Errors: a damaged database.
    [[nodiscard]] Result<std::vector<world::PlacedEntry>>
    around(const dat::Archive& archive, dat::BlockCoord centre, const world::LoadOptions& options) const;

    /// A viewpoint before a visible object, which looks at it. `name`: that of the object, with its guid; else that of its
    /// template, or a part of it; letter case of ASCII does not matter, and the object with the least guid is taken. None:
    /// there is no such object. Errors: a damaged database.
    [[nodiscard]] Result<std::optional<world::Place>> viewOf(const std::string& name) const;

    /// The position of the object that viewOf() looks at.
    [[nodiscard]] Result<std::optional<Vec3>> positionOf(const std::string& name) const;

    /// The same view of the object with a guid.
    [[nodiscard]] Result<std::optional<world::Place>> viewOf(std::uint32_t guid) const;

    /// Visible objects whose template's name contains a text, at most `limit`, the nearest to `from` first (global, metres,
    /// along the ground). Letter case of ASCII does not matter. An empty text finds nothing. Errors: a damaged database.
    [[nodiscard]] Result<std::vector<FoundObject>> search(const std::string& name, const Vec3& from,
                                                          std::size_t limit) const;

    /// The position of every placed object of a type, visible or not, global, in any order. `proceed` is called for each; false
    /// ends the reading. Errors: a damaged database.
    [[nodiscard]] Result<std::vector<Vec3>> positionsOf(placements::TemplateType type,
                                                        const std::function<bool()>& proceed = {}) const;

    [[nodiscard]] const placements::WorldDb& database() const { return database_; }

private:
    /// The objects with a name, as viewOf() describes it, the best one first; visible or not.
    [[nodiscard]] Result<std::vector<placements::Placement>> named(const std::string& name) const;
    /// Requires the lock. None: it is not visible.
    [[nodiscard]] std::optional<world::Place> viewOfPlacement(const placements::Placement& placement) const;
    [[nodiscard]] Result<void> addBlock(dat::BlockCoord block, std::vector<world::PlacedEntry>& out) const;
    /// Null: there is no such template, or the database is damaged (`fault_` then says so).
    [[nodiscard]] const placements::Template* find(std::uint32_t id) const;

    placements::WorldDb database_;
    mutable std::mutex lock_; ///< of the members below
    mutable std::map<std::uint32_t, std::optional<placements::Template>> templates_;
    mutable Result<void> fault_;
};

/// An object as an entry for the loader. `find`: yields the templates of the things that it wears.
[[nodiscard]] world::PlacedEntry placedEntry(const placements::Standing& standing,
                                             const placements::Template& of,
                                             const placements::FindTemplate& find);

} // namespace limen::engine
