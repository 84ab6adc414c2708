#pragma once

#include "core/Error.h"
#include "placements/Placements.h"

#include <filesystem>
#include <functional>
#include <memory>

namespace limen::placements {

inline constexpr const char* kWorldDbName = "world.db";

/// The source of the content of a world.db.
struct Origin {
    std::string source; ///< a URL without password, or paths
    std::string time;   ///< of the import: ISO 8601, UTC
};

/// Differences between a content and the file that it replaces.
struct WriteCounts {
    std::size_t placements = 0, templates = 0; ///< in the content
    std::size_t landblocksWritten = 0, landblocksRemoved = 0;
    std::size_t templatesWritten = 0, templatesRemoved = 0;
    [[nodiscard]] bool isUnchanged() const {
        return landblocksWritten + landblocksRemoved + templatesWritten + templatesRemoved == 0;
    }
};

/// Makes `path` a world.db with this content. An existing one gets only the landblocks and templates that differ; without
/// any difference it is not touched. The new file is written beside its place and then renamed, so that the old one stays
/// on failure. `proceed`: called between landblocks; false ends the writing with an error. Errors: another file has this
/// name; the directory cannot be written; a full disk.
[[nodiscard]] Result<WriteCounts> writeWorldDb(const std::filesystem::path& path, const Content& content,
                                               const Origin& origin,
                                               const std::function<bool()>& proceed = {});

/// A placed object that a search found.
struct Found {
    Placement placement;
    std::string name; ///< of its template
    std::int32_t type = 0;
};

/// An open world.db. Reads by landblock and by template; keeps nothing in memory. Safe on several threads, one call
/// at a time.
class WorldDb {
public:
    /// Errors: no such file; no world.db; a version that this program does not know.
    [[nodiscard]] static Result<WorldDb> open(const std::filesystem::path& path);

    WorldDb(WorldDb&&) noexcept;
    WorldDb& operator=(WorldDb&&) noexcept;
    ~WorldDb();

    [[nodiscard]] const std::filesystem::path& path() const;
    [[nodiscard]] Result<Origin> origin() const;

    // Errors of the following: a damaged file. An unknown landblock has no objects.
    [[nodiscard]] Result<Landblock> landblock(std::uint32_t id) const;
    [[nodiscard]] Result<std::vector<std::uint32_t>> landblocks() const; ///< ascending
    [[nodiscard]] Result<std::optional<Template>> findTemplate(std::uint32_t id) const;
    [[nodiscard]] Result<Content> readAll() const;

    /// Placed objects whose template's name contains a text, by name, then by guid. Letter case of ASCII does not
    /// matter. An empty text finds all objects. `type`: only templates of this type. At most `limit`.
    [[nodiscard]] Result<std::vector<Found>> search(const std::string& name, std::optional<std::int32_t> type,
                                                    std::size_t limit) const;
    /// Calls `visit` with the place of every object whose template has a type, in any order, until it returns false. The
    /// database is locked meanwhile.
    [[nodiscard]] Result<void> eachOfType(std::int32_t type,
                                          const std::function<bool(const Spot&)>& visit) const;
    [[nodiscard]] Result<std::optional<Placement>> findPlacement(std::uint32_t guid) const;

private:
    struct Open;
    explicit WorldDb(std::unique_ptr<Open> open);
    std::unique_ptr<Open> open_;
};

} // namespace limen::placements
