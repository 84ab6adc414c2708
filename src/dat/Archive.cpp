#include "dat/Archive.h"

#include "dat/RecordTypes.h"

#include <system_error>

#include <fmt/format.h>

namespace limen::dat {
namespace {

const char* nameOf(FileRole role) {
    switch (role) {
    case FileRole::Portal:
        return "portal";
    case FileRole::Cell:
        return "cell";
    case FileRole::Highres:
        return "highres";
    case FileRole::Local:
        return "local";
    }
    return "unknown";
}

Result<File> openAs(const std::filesystem::path& path, FileRole role) {
    auto file = File::open(path);
    if (file && file->role() != role) {
        return fail(ErrorCode::Malformed, path.string(),
                    fmt::format("its header says that it is a {} file; a {} file was expected",
                                nameOf(file->role()), nameOf(role)));
    }
    return file;
}

/// True if there are files with the names from before the end of retail, and not those of today.
bool holdsOlderGame(const std::filesystem::path& directory) {
    std::error_code error;
    return !std::filesystem::exists(directory / kPortalName, error) &&
           (std::filesystem::exists(directory / "portal.dat", error) ||
            std::filesystem::exists(directory / "cell.dat", error));
}

/// True if `file` has `id`. False if its index is damaged.
bool has(const File& file, RecordId id) {
    const auto entry = file.find(id);
    return entry && *entry;
}

} // namespace

Result<Archive> Archive::open(const std::filesystem::path& directory) {
    std::error_code error;
    if (!std::filesystem::is_directory(directory, error))
        return fail(ErrorCode::NotFound, directory.string(), "there is no such directory");
    if (holdsOlderGame(directory)) {
        return fail(
            ErrorCode::Unsupported, directory.string(),
            "portal.dat and cell.dat are game files older than the end of retail; only end-of-retail files "
            "(client_portal.dat, client_cell_1.dat) can be read");
    }
    const auto ifPresent = [&](const char* name) {
        return std::filesystem::exists(directory / name, error) ? directory / name : std::filesystem::path();
    };
    return open(ArchivePaths{directory, directory / kPortalName, directory / kCellName,
                             ifPresent(kHighresName), ifPresent(kLocalName)});
}

Result<Archive> Archive::open(const ArchivePaths& paths) {
    auto portal = openAs(paths.portal, FileRole::Portal);
    if (!portal)
        return Failure(portal.error());
    auto cell = openAs(paths.cell, FileRole::Cell);
    if (!cell)
        return Failure(cell.error());
    Archive archive(paths.directory, std::move(*portal), std::move(*cell));
    const auto openIfNamed = [](const std::filesystem::path& path, FileRole role,
                                std::optional<File>& into) -> Result<void> {
        if (path.empty())
            return {};
        auto file = openAs(path, role);
        if (!file)
            return Failure(file.error());
        into = std::move(*file);
        return {};
    };
    if (auto done = openIfNamed(paths.highres, FileRole::Highres, archive.highres_); !done)
        return Failure(done.error());
    if (auto done = openIfNamed(paths.local, FileRole::Local, archive.local_); !done)
        return Failure(done.error());
    return archive;
}

const File* Archive::holderOf(RecordKind kind, RecordId id) const {
    if (isOfCells(kind))
        return &cell_;
    if (kind == RecordKind::RenderSurface && highres_ && !has(portal_, id) && has(*highres_, id))
        return &*highres_;
    return &portal_;
}

template <class Record>
Result<Record> Archive::load(RecordId id) const {
    constexpr RecordKind kind = kKindOf<Record>;
    const File& file = *holderOf(kind, id);
    if (kindOf(file.role(), id) != kind) {
        return fail(ErrorCode::NotFound, file.name(),
                    fmt::format("0x{:08X} is not the id of a {}", id, limen::dat::nameOf(kind)));
    }
    Bytes scratch;
    const auto payload = file.read(id, scratch);
    if (!payload)
        return Failure(payload.error());
    auto record = decode<Record>(id, *payload);
    if (!record)
        record.error().where = file.name() + ", " + record.error().where;
    return record;
}

template <class Record>
bool Archive::contains(RecordId id) const {
    constexpr RecordKind kind = kKindOf<Record>;
    const File& file = *holderOf(kind, id);
    return kindOf(file.role(), id) == kind && has(file, id);
}

Result<RecordId> Archive::imageOf(const SurfaceTexture& texture) const {
    for (const RecordId id : texture.images)
        if (contains<RenderSurface>(id))
            return id;
    return fail(
        ErrorCode::NotFound, fmt::format("{}, record 0x{:08X}", portal_.name(), texture.id),
        fmt::format("none of its {} images is in the portal file or in highres", texture.images.size()));
}

void Archive::letPagesGo() const {
    for (const File* file : {&portal_, &cell_, highres(), local()})
        if (file != nullptr)
            file->letPagesGo();
}

void Archive::letPagesGoEvery(std::size_t bytes) {
    portal_.letPagesGoEvery(bytes);
    cell_.letPagesGoEvery(bytes);
    for (std::optional<File>* file : {&highres_, &local_})
        if (*file)
            (*file)->letPagesGoEvery(bytes);
}

#define LIMEN_DAT_RECORD(Record)                                                                             \
    template Result<Record> Archive::load<Record>(RecordId) const;                                           \
    template bool Archive::contains<Record>(RecordId) const;
LIMEN_DAT_RECORD(GfxObj)
LIMEN_DAT_RECORD(Setup)
LIMEN_DAT_RECORD(Animation)
LIMEN_DAT_RECORD(Palette)
LIMEN_DAT_RECORD(SurfaceTexture)
LIMEN_DAT_RECORD(RenderSurface)
LIMEN_DAT_RECORD(Surface)
LIMEN_DAT_RECORD(MotionTable)
LIMEN_DAT_RECORD(Environment)
LIMEN_DAT_RECORD(PaletteSet)
LIMEN_DAT_RECORD(ClothingTable)
LIMEN_DAT_RECORD(DegradeInfo)
LIMEN_DAT_RECORD(Scene)
LIMEN_DAT_RECORD(Region)
LIMEN_DAT_RECORD(ParticleEmitter)
LIMEN_DAT_RECORD(PhysicsScript)
LIMEN_DAT_RECORD(PhysicsScriptTable)
LIMEN_DAT_RECORD(LandBlock)
LIMEN_DAT_RECORD(LandBlockInfo)
LIMEN_DAT_RECORD(EnvCell)
#undef LIMEN_DAT_RECORD

} // namespace limen::dat
