#include "core/platform/Files.h"
#include "core/platform/Process.h"
#include "placements/WorldDb.h"
#include "placements/store/ContentHash.h"
#include "placements/store/ContentWriter.h"
#include "placements/store/Schema.h"
#include "placements/store/Sqlite.h"

#include <fmt/format.h>
#include <unordered_map>

namespace limen::placements {
namespace {

namespace fs = std::filesystem;
using Hashes = std::unordered_map<std::uint32_t, std::uint64_t>;

/// The hashes of a file's landblocks and templates.
struct Known {
    Hashes landblocks, templates;
};

Result<Hashes> hashesOf(const Sqlite& file, const char* sql) {
    Hashes hashes;
    Result<Query> query = file.prepare(sql);
    if (!query)
        return Failure(query.error());
    for (;;) {
        const Result<bool> row = query->step();
        if (!row)
            return Failure(row.error());
        if (!*row)
            return hashes;
        hashes.emplace(static_cast<std::uint32_t>(query->integer(0)),
                       static_cast<std::uint64_t>(query->integer(1)));
    }
}

/// Empty for a path without a file, and for a world.db of another version, which is written as a whole.
Result<std::optional<Known>> knownAt(const fs::path& path) {
    std::error_code error;
    if (!fs::exists(path, error))
        return std::nullopt;
    Result<Sqlite> file = Sqlite::open(path, Sqlite::Mode::Read);
    const Result<std::int64_t> id = file ? file->number("PRAGMA application_id") : Failure(file.error());
    if (!id || *id != kApplicationId)
        return fail(ErrorCode::BadArgument, path.string(),
                    "another file has this name, and it is not replaced; choose another one with -o FILE");
    const Result<std::int64_t> version = file->number("PRAGMA user_version");
    if (!version || *version != kSchemaVersion)
        return std::nullopt;
    Result<Hashes> landblocks = hashesOf(*file, "SELECT id, hash FROM landblock");
    Result<Hashes> templates = hashesOf(*file, "SELECT id, hash FROM template");
    if (!landblocks || !templates)
        return std::nullopt; // damaged: written as a whole
    return Known{std::move(*landblocks), std::move(*templates)};
}

/// A file beside its place, which is removed unless it was renamed.
class PartFile {
public:
    explicit PartFile(fs::path place)
        : place_(std::move(place)), part_(place_.string() + fmt::format(".part-{}", platform::processId())) {
        std::error_code ignored;
        fs::remove(part_, ignored); // of a process that was killed
    }
    ~PartFile() {
        std::error_code ignored;
        if (!isRenamed_)
            fs::remove(part_, ignored);
    }
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;

    [[nodiscard]] const fs::path& path() const { return part_; }

    Result<void> copyPlace() {
        std::error_code error;
        fs::copy_file(place_, part_, fs::copy_options::overwrite_existing, error);
        if (!error)
            fs::permissions(part_, fs::perms::owner_write, fs::perm_options::add, error);
        return error ? unwritable(error.message()) : Result<void>();
    }

    /// Writes all bytes to the disk, then gives the file its name.
    Result<void> rename() {
        if (!platform::flushToDisk(part_))
            return unwritable("its bytes cannot be written to the disk");
        std::error_code error;
        fs::rename(part_, place_, error);
        if (error)
            return unwritable(error.message());
        isRenamed_ = true;
        return {};
    }

    [[nodiscard]] Result<void> unwritable(const std::string& reason) const {
        return fail(ErrorCode::Unreadable, place_.string(), "cannot be written: " + reason);
    }

private:
    fs::path place_, part_;
    bool isRenamed_ = false;
};

/// The changes that make a file have a content.
struct Changes {
    std::vector<std::uint32_t> removedLandblocks, removedTemplates;             ///< those that differ, too
    std::vector<std::pair<std::uint32_t, std::uint64_t>> landblocks, templates; ///< with their hashes
};

/// Compares one kind of content with the known hashes.
template <class Map>
void compare(const Map& map, const Hashes& known, std::vector<std::uint32_t>& removed,
             std::vector<std::pair<std::uint32_t, std::uint64_t>>& written) {
    for (const auto& [id, value] : map) {
        const std::uint64_t hash = hashOf(value);
        const auto found = known.find(id);
        if (found != known.end() && found->second == hash)
            continue;
        written.emplace_back(id, hash);
        if (found != known.end())
            removed.push_back(id);
    }
    for (const auto& [id, hash] : known)
        if (!map.contains(id))
            removed.push_back(id);
}

Result<void> apply(const Changes& changes, const Content& content, ContentWriter& writer,
                   const std::function<bool()>& proceed) {
    for (const std::uint32_t id : changes.removedLandblocks)
        if (Result<void> done = writer.removeLandblock(id); !done)
            return done;
    for (const std::uint32_t id : changes.removedTemplates)
        if (Result<void> done = writer.removeTemplate(id); !done)
            return done;
    for (const auto& [id, hash] : changes.landblocks) {
        if (proceed && !proceed())
            return fail(ErrorCode::Unreadable, "", "the import was cancelled");
        if (Result<void> done = writer.add(id, content.landblocks.at(id), hash); !done)
            return done;
    }
    for (const auto& [id, hash] : changes.templates)
        if (Result<void> done = writer.add(content.templates.at(id), hash); !done)
            return done;
    return {};
}

Result<void> writeOrigin(Sqlite& file, const Origin& origin) {
    Result<Query> query = file.prepare("INSERT OR REPLACE INTO meta VALUES(?,?)");
    if (!query)
        return Failure(query.error());
    for (const auto& [key, value] : {std::pair{"source", origin.source}, std::pair{"time", origin.time}}) {
        query->bindText(0, key);
        query->bindText(1, value);
        if (Result<void> done = query->execute(); !done)
            return done;
    }
    return {};
}

Result<void> writeChanges(const fs::path& part, bool isNew, const Changes& changes, const Content& content,
                          const Origin& origin, const std::function<bool()>& proceed) {
    Result<Sqlite> file = Sqlite::open(part, isNew ? Sqlite::Mode::Create : Sqlite::Mode::Change);
    if (!file)
        return Failure(file.error());
    // The file has no readers until it is renamed, and is thrown away on failure: it needs no journal.
    constexpr const char* kFast =
        "PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF; PRAGMA locking_mode=EXCLUSIVE;"
        "PRAGMA cache_size=-65536;";
    const std::string marks =
        fmt::format("PRAGMA application_id={}; PRAGMA user_version={};", kApplicationId, kSchemaVersion);
    ContentWriter writer;
    return file->run(kFast)
        .and_then([&] { return isNew ? file->run((marks + kSchema).c_str()) : Result<void>(); })
        .and_then([&] { return file->run("BEGIN"); })
        .and_then([&] { return writer.prepare(*file); })
        .and_then([&] { return apply(changes, content, writer, proceed); })
        .and_then([&] { return writeOrigin(*file, origin); })
        .and_then([&] { return file->run("COMMIT"); });
}

} // namespace

Result<WriteCounts> writeWorldDb(const fs::path& path, const Content& content, const Origin& origin,
                                 const std::function<bool()>& proceed) {
    const Result<std::optional<Known>> known = knownAt(path);
    if (!known)
        return Failure(known.error());
    const bool isNew = !known->has_value();
    Changes changes;
    const Known before = isNew ? Known() : **known;
    compare(content.landblocks, before.landblocks, changes.removedLandblocks, changes.landblocks);
    compare(content.templates, before.templates, changes.removedTemplates, changes.templates);
    WriteCounts counts;
    counts.placements = countPlacements(content);
    counts.templates = content.templates.size();
    counts.landblocksWritten = changes.landblocks.size();
    counts.templatesWritten = changes.templates.size();
    for (const std::uint32_t id : changes.removedLandblocks)
        counts.landblocksRemoved += content.landblocks.contains(id) ? 0 : 1;
    for (const std::uint32_t id : changes.removedTemplates)
        counts.templatesRemoved += content.templates.contains(id) ? 0 : 1;
    if (!isNew && counts.isUnchanged())
        return counts;
    PartFile part(path);
    return (isNew ? Result<void>() : part.copyPlace())
        .and_then([&] { return writeChanges(part.path(), isNew, changes, content, origin, proceed); })
        .and_then([&] { return part.rename(); })
        .map([&] { return counts; });
}

} // namespace limen::placements
