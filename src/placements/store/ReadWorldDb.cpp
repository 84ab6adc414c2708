#include "placements/TemplateFields.h"
#include "placements/WorldDb.h"
#include "placements/store/Schema.h"
#include "placements/store/Sqlite.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <mutex>

namespace limen::placements {
namespace {

constexpr const char* kPlacementColumns =
    "SELECT p.guid, p.template, p.cell, p.x, p.y, p.z, p.qw, p.qx, p.qy, p.qz, p.is_link_child";

/// Numbers of a file that may be damaged: out of range gives 0.
template <class T>
T integerAt(const Query& query, int column) {
    const std::int64_t value = query.integer(column);
    const bool fits = value >= std::int64_t{std::numeric_limits<T>::min()} &&
                      value <= std::int64_t{std::numeric_limits<T>::max()};
    return fits ? static_cast<T>(value) : T{0};
}
float floatAt(const Query& query, int column) {
    const double value = query.real(column);
    return std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max())
               ? static_cast<float>(value)
               : 0.0f;
}
double doubleAt(const Query& query, int column) {
    const double value = query.real(column);
    return std::isfinite(value) ? value : 0.0;
}

template <class T>
void readOptional(const Query& query, int column, std::optional<T>& out) {
    if (query.isNull(column))
        return;
    if constexpr (std::is_same_v<T, bool>)
        out = query.integer(column) != 0;
    else if constexpr (std::is_same_v<T, double>)
        out = doubleAt(query, column);
    else if constexpr (std::is_same_v<T, float>)
        out = floatAt(query, column);
    else
        out = integerAt<T>(query, column);
}

Spot spotAt(const Query& query, int first) {
    Spot spot;
    spot.cell = integerAt<std::uint32_t>(query, first);
    for (int i = 0; i < 3; ++i)
        spot.origin[static_cast<std::size_t>(i)] = floatAt(query, first + 1 + i);
    for (int i = 0; i < 4; ++i)
        spot.angles[static_cast<std::size_t>(i)] = floatAt(query, first + 4 + i);
    return spot;
}

Placement placementAt(const Query& query) {
    return {integerAt<std::uint32_t>(query, 0), integerAt<std::uint32_t>(query, 1), spotAt(query, 2),
            query.integer(10) != 0};
}

Template templateAt(const Query& query) {
    Template of;
    of.id = integerAt<std::uint32_t>(query, 0);
    of.className = query.text(2);
    of.type = integerAt<std::int32_t>(query, 3);
    of.name = query.text(4);
    int next = 5;
    for (const auto& field : kIdFields)
        of.*(field.member) = integerAt<std::uint32_t>(query, next++);
    for (const auto& field : kIntFields)
        readOptional(query, next++, of.*(field.member));
    for (const auto& field : kRealFields)
        readOptional(query, next++, of.*(field.member));
    for (const auto& field : kBoolFields)
        readOptional(query, next++, of.*(field.member));
    return of;
}

GeneratorEntry generatorAt(const Query& query) {
    GeneratorEntry entry;
    entry.probability = floatAt(query, 2);
    entry.templateId = integerAt<std::uint32_t>(query, 3);
    entry.initCreate = integerAt<std::int32_t>(query, 4);
    entry.maxCreate = integerAt<std::int32_t>(query, 5);
    entry.whenCreate = integerAt<std::uint32_t>(query, 6);
    entry.whereCreate = integerAt<std::uint32_t>(query, 7);
    readOptional(query, 8, entry.palette);
    readOptional(query, 9, entry.shade);
    if (!query.isNull(10))
        entry.spot = spotAt(query, 10);
    return entry;
}

/// Calls `take` for each row of a query with one integer parameter.
template <class Take>
Result<void> forEach(const Sqlite& file, std::string_view sql, std::int64_t key, Take&& take) {
    Result<Query> query = file.prepare(sql);
    if (!query)
        return Failure(query.error());
    if (sql.find('?') != std::string_view::npos)
        query->bind(0, key);
    for (;;) {
        const Result<bool> row = query->step();
        if (!row)
            return Failure(row.error());
        if (!*row)
            return {};
        take(*query);
    }
}

/// Fills the lists of templates: of one, or of all if `sql` ends without a condition. `find` yields the template of a
/// row, or null.
template <class Find>
Result<void> readLists(const Sqlite& file, const char* condition, std::int64_t key, Find&& find) {
    const auto each = [&](const char* table, auto&& take) {
        return forEach(file, fmt::format("SELECT * FROM {} {} ORDER BY 1, 2", table, condition), key,
                       [&](const Query& row) {
                           if (Template* of = find(integerAt<std::uint32_t>(row, 0)))
                               take(*of, row);
                       });
    };
    return each("template_palette",
                [](Template& of, const Query& row) {
                    of.palettes.push_back({integerAt<std::uint32_t>(row, 2), integerAt<std::uint16_t>(row, 3),
                                           integerAt<std::uint16_t>(row, 4)});
                })
        .and_then([&] {
            return each("template_texture", [](Template& of, const Query& row) {
                of.textures.push_back({integerAt<std::uint8_t>(row, 2), integerAt<std::uint32_t>(row, 3),
                                       integerAt<std::uint32_t>(row, 4)});
            });
        })
        .and_then([&] {
            return each("template_part", [](Template& of, const Query& row) {
                of.parts.push_back({integerAt<std::uint8_t>(row, 2), integerAt<std::uint32_t>(row, 3)});
            });
        })
        .and_then([&] {
            return each("template_item", [](Template& of, const Query& row) {
                of.items.push_back({integerAt<std::int32_t>(row, 2), integerAt<std::uint32_t>(row, 3),
                                    integerAt<std::int32_t>(row, 4), floatAt(row, 5)});
            });
        })
        .and_then([&] {
            return each("template_generator",
                        [](Template& of, const Query& row) { of.generator.push_back(generatorAt(row)); });
        })
        .and_then([&] {
            return each("template_destination",
                        [](Template& of, const Query& row) { of.destination = spotAt(row, 1); });
        });
}

} // namespace

struct WorldDb::Open {
    Open(std::filesystem::path at, Sqlite opened) : path(std::move(at)), file(std::move(opened)) {}
    std::filesystem::path path;
    Sqlite file;
    std::mutex lock;
};

WorldDb::WorldDb(std::unique_ptr<Open> open) : open_(std::move(open)) {}
WorldDb::WorldDb(WorldDb&&) noexcept = default;
WorldDb& WorldDb::operator=(WorldDb&&) noexcept = default;
WorldDb::~WorldDb() = default;

Result<WorldDb> WorldDb::open(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::exists(path, error))
        return fail(ErrorCode::NotFound, path.string(), "no such file; write it with limen world import");
    Result<Sqlite> file = Sqlite::open(path, Sqlite::Mode::Read);
    if (!file)
        return Failure(file.error());
    const Result<std::int64_t> id = file->number("PRAGMA application_id");
    if (!id)
        return Failure(id.error());
    if (*id != kApplicationId)
        return fail(ErrorCode::Malformed, path.string(),
                    "is not a world.db of Limen; write one with limen world import");
    const Result<std::int64_t> version = file->number("PRAGMA user_version");
    if (!version)
        return Failure(version.error());
    if (*version != kSchemaVersion)
        return fail(
            ErrorCode::Unsupported, path.string(),
            fmt::format("has version {}, but this program reads version {}; write it again with limen "
                        "world import",
                        *version, kSchemaVersion));
    return WorldDb(std::make_unique<Open>(path, std::move(*file)));
}

const std::filesystem::path& WorldDb::path() const {
    return open_->path;
}

Result<Origin> WorldDb::origin() const {
    const std::lock_guard guard(open_->lock);
    Origin origin;
    return forEach(open_->file, "SELECT key, value FROM meta", 0,
                   [&](const Query& row) {
                       if (row.text(0) == "source")
                           origin.source = row.text(1);
                       else if (row.text(0) == "time")
                           origin.time = row.text(1);
                   })
        .map([&] { return origin; });
}

Result<Landblock> WorldDb::landblock(std::uint32_t id) const {
    const std::lock_guard guard(open_->lock);
    Landblock landblock;
    const std::string sql =
        fmt::format("{} FROM placement p WHERE landblock = ? ORDER BY guid", kPlacementColumns);
    return forEach(open_->file, sql, id,
                   [&](const Query& row) { landblock.placements.push_back(placementAt(row)); })
        .and_then([&] {
            return forEach(open_->file,
                           "SELECT parent, child FROM link WHERE landblock = ? ORDER BY parent, child", id,
                           [&](const Query& row) {
                               landblock.links.push_back(
                                   {integerAt<std::uint32_t>(row, 0), integerAt<std::uint32_t>(row, 1)});
                           });
        })
        .map([&] { return std::move(landblock); });
}

Result<std::vector<std::uint32_t>> WorldDb::landblocks() const {
    const std::lock_guard guard(open_->lock);
    std::vector<std::uint32_t> ids;
    return forEach(open_->file, "SELECT id FROM landblock ORDER BY id", 0,
                   [&](const Query& row) { ids.push_back(integerAt<std::uint32_t>(row, 0)); })
        .map([&] { return std::move(ids); });
}

Result<std::optional<Template>> WorldDb::findTemplate(std::uint32_t id) const {
    const std::lock_guard guard(open_->lock);
    std::optional<Template> found;
    return forEach(open_->file, "SELECT * FROM template WHERE id = ?", id,
                   [&](const Query& row) { found = templateAt(row); })
        .and_then([&] {
            return readLists(open_->file, "WHERE template = ?", id,
                             [&](std::uint32_t) { return found ? &*found : nullptr; });
        })
        .map([&] { return std::move(found); });
}

Result<Content> WorldDb::readAll() const {
    Content content;
    const Result<std::vector<std::uint32_t>> ids = landblocks();
    if (!ids)
        return Failure(ids.error());
    for (const std::uint32_t id : *ids) {
        Result<Landblock> read = landblock(id);
        if (!read)
            return Failure(read.error());
        content.landblocks.emplace(id, std::move(*read));
    }
    const std::lock_guard guard(open_->lock);
    return forEach(open_->file, "SELECT * FROM template", 0,
                   [&](const Query& row) {
                       Template of = templateAt(row);
                       content.templates.emplace(of.id, std::move(of));
                   })
        .and_then([&] {
            return readLists(open_->file, "", 0, [&](std::uint32_t id) {
                const auto found = content.templates.find(id);
                return found != content.templates.end() ? &found->second : nullptr;
            });
        })
        .map([&] { return std::move(content); });
}

Result<std::vector<Found>> WorldDb::search(const std::string& name, std::optional<std::int32_t> type,
                                           std::size_t limit) const {
    const std::lock_guard guard(open_->lock);
    // Templates first: they are a tenth as many. Only without a name and a type do objects without a template count.
    const bool wantsAll = name.empty() && !type;
    const std::string sql =
        fmt::format("{}, t.name, t.type FROM {} ON t.id = p.template "
                    "WHERE (?1 = '' OR instr(lower(t.name), lower(?1)) > 0) AND (?2 IS NULL OR t.type = ?2) "
                    "ORDER BY t.name, p.guid LIMIT ?3",
                    kPlacementColumns,
                    wantsAll ? "placement p LEFT JOIN template t" : "template t CROSS JOIN placement p");
    Result<Query> query = open_->file.prepare(sql);
    if (!query)
        return Failure(query.error());
    query->bindText(0, name);
    if (type)
        query->bind(1, *type);
    else
        query->bindNull(1);
    query->bind(2, static_cast<std::int64_t>(std::min<std::size_t>(limit, 1'000'000'000)));
    std::vector<Found> found;
    for (;;) {
        const Result<bool> row = query->step();
        if (!row)
            return Failure(row.error());
        if (!*row)
            return found;
        found.push_back({placementAt(*query), query->text(11), integerAt<std::int32_t>(*query, 12)});
    }
}

Result<void> WorldDb::eachOfType(std::int32_t type, const std::function<bool(const Spot&)>& visit) const {
    const std::lock_guard guard(open_->lock);
    Result<Query> query = open_->file.prepare(
        "SELECT p.cell, p.x, p.y, p.z, p.qw, p.qx, p.qy, p.qz FROM placement p "
        "WHERE +p.template IN (SELECT id FROM template WHERE type = ?)"); // +: reads the table in order
    if (!query)
        return Failure(query.error());
    query->bind(0, type);
    for (;;) {
        const Result<bool> row = query->step();
        if (!row)
            return Failure(row.error());
        if (!*row || !visit(spotAt(*query, 0)))
            return {};
    }
}

Result<std::optional<Placement>> WorldDb::findPlacement(std::uint32_t guid) const {
    const std::lock_guard guard(open_->lock);
    std::optional<Placement> found;
    return forEach(open_->file, fmt::format("{} FROM placement p WHERE guid = ?", kPlacementColumns), guid,
                   [&](const Query& row) { found = placementAt(row); })
        .map([&] { return found; });
}

} // namespace limen::placements
