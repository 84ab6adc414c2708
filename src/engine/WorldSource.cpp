#include "engine/WorldSource.h"

#include "engine/DatDirectory.h"
#include "worlds/Demo.h"

namespace limen::engine {
namespace {

constexpr dat::RecordId kHumanMale = 0x02000001; // setup (docs/uncertain.md)

Result<WorldSource> openDirectory(const dat::ArchivePaths& paths, PlaceSearch search,
                                  const SearchProgress& progress) {
    Result<dat::Archive> archive = dat::Archive::open(paths);
    if (!archive)
        return Failure(archive.error());
    constexpr std::size_t kBetween = std::size_t{16} << 20; // bytes that are read
    archive->letPagesGoEvery(kBetween); // the pages of a file count as the program's memory
    Result<world::WorldFile> file = world::loadWorldFile(paths.directory);
    if (!file)
        return Failure(file.error());
    bool isSearched = false;
    std::error_code ignored;
    if (!std::filesystem::exists(paths.directory / world::kWorldFileName, ignored)) {
        isSearched = search == PlaceSearch::Find;
        if (isSearched) {
            file = findPlacesCached(*archive, cacheRoot(), kWorthCaching, progress);
            if (!file)
                return Failure(file.error());
        }
        // The original game's files have no world.json. The player's body is then the game's human male.
        if (archive->contains<dat::Setup>(kHumanMale))
            file->moving.player = kHumanMale;
    }
    std::unique_ptr<PlacedObjects> placed;
    if (std::filesystem::exists(paths.directory / placements::kWorldDbName, ignored)) {
        Result<placements::WorldDb> database =
            placements::WorldDb::open(paths.directory / placements::kWorldDbName);
        if (!database)
            return Failure(database.error());
        placed = std::make_unique<PlacedObjects>(std::move(*database));
    }
    return WorldSource{{}, std::move(*archive), std::move(*file), "", isSearched, std::move(placed)};
}

Result<WorldSource> openAt(const std::filesystem::path& path, PlaceSearch search,
                           const SearchProgress& progress) {
    return findDatDirectory(path).and_then(
        [&](const DatDirectory& there) { return openDirectory(there.paths, search, progress); });
}

/// Opens the cached world. If it is damaged (by a full disk, or by another program), it is written again,
/// once.
Result<WorldSource> openBuiltIn(const SearchProgress& progress) {
    const std::string key = programKey();
    for (int attempt = 0;; ++attempt) {
        Result<BuiltInWorld> builtIn = openBuiltInWorld(cacheRoot(), key, worlds::writeBuiltInWorld);
        if (!builtIn)
            return Failure(builtIn.error());
        Result<WorldSource> source = openAt(builtIn->directory(), PlaceSearch::Find, progress);
        if (source)
            source->builtIn = std::move(*builtIn);
        if (source || attempt == 1)
            return source;
        discardBuiltInWorld(*builtIn);
    }
}

} // namespace

Result<world::MovingEntries> movingAround(const WorldSource& source, dat::BlockCoord centre,
                                          const world::LoadOptions& options) {
    world::MovingEntries moving = source.file.moving;
    if (source.placed == nullptr)
        return moving;
    return source.placed->around(source.archive, centre, options)
        .map([&](std::vector<world::PlacedEntry>&& placed) {
            moving.placed = std::move(placed);
            return std::move(moving);
        });
}

Result<ViewRequest> resolvePlace(ViewRequest request, const WorldSource& source) {
    Result<ViewRequest> resolved = resolvePlace(request, source.file);
    if (resolved || source.placed == nullptr)
        return resolved;
    const Result<std::optional<world::Place>> object = source.placed->viewOf(request.place);
    if (!object)
        return Failure(object.error());
    if (!*object)
        return resolved;
    ViewRequest view = requestAt(**object);
    request.place.clear();
    request.eye = view.eye;
    request.isOnGround = false;
    request.yaw = request.yaw.value_or(*view.yaw);
    request.pitch = request.pitch.value_or(0.0);
    request.root = request.root.value_or(*view.root);
    return request;
}

Result<std::vector<world::Place>> tourOf(const WorldSource& source, const SearchProgress& progress) {
    if (source.isSearched || !source.file.tour.empty())
        return source.file.tour;
    return findPlacesCached(source.archive, cacheRoot(), kWorthCaching, progress)
        .map([](world::WorldFile&& found) { return std::move(found.tour); });
}

Result<WorldSource> openWorldSource(const std::string& path, PlaceSearch search,
                                    const SearchProgress& progress) {
    if (path.empty())
        return openBuiltIn(progress);
    Result<WorldSource> source = openAt(path, search, progress);
    if (source) {
        // A command that draws a frame again names the directory itself, and not one above it.
        std::error_code error;
        const std::filesystem::path& there = source->archive.directory();
        const bool isGiven = std::filesystem::equivalent(path, there, error);
        source->datOption = " --dat '" + (isGiven ? path : there.string()) + "'";
    }
    return source;
}

} // namespace limen::engine
