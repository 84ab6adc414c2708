#include "cli/world/PlacedWorld.h"

#include "engine/WorldSource.h"
#include "output/OutputFile.h"

namespace limen::cli {
namespace {

namespace fs = std::filesystem;

Result<PlacedWorld> openWorldFile(const fs::path& path) {
    constexpr std::size_t kMostBytes = std::size_t{1} << 30;
    const Result<std::string> text = output::readTextFile(path, kMostBytes);
    if (!text)
        return Failure(text.error());
    Result<world::WorldFile> file = world::parseWorldFile(*text, path.string());
    if (!file)
        return Failure(file.error());
    PlacedWorld world;
    world.file = std::make_unique<world::WorldFile>(std::move(*file));
    world.path = path;
    return world;
}

Result<PlacedWorld> openDatabase(const fs::path& path) {
    Result<placements::WorldDb> database = placements::WorldDb::open(path);
    if (!database)
        return Failure(database.error());
    PlacedWorld world;
    world.database = std::make_unique<placements::WorldDb>(std::move(*database));
    world.path = path;
    return world;
}

} // namespace

Result<PlacedWorld> openPlacedWorld(const std::string& path) {
    std::error_code ignored;
    if (fs::is_regular_file(path, ignored))
        return fs::path(path).extension() == ".json" ? openWorldFile(path) : openDatabase(path);
    fs::path directory = path;
    std::unique_ptr<engine::WorldSource> source; // keeps the directory of the built-in world
    if (path.empty() || (!fs::exists(directory / placements::kWorldDbName, ignored) &&
                         !fs::exists(directory / world::kWorldFileName, ignored))) {
        Result<engine::WorldSource> opened = engine::openWorldSource(path, engine::PlaceSearch::Skip);
        if (!opened)
            return Failure(opened.error());
        source = std::make_unique<engine::WorldSource>(std::move(*opened));
        directory = source->archive.directory();
    }
    if (fs::exists(directory / placements::kWorldDbName, ignored))
        return openDatabase(directory / placements::kWorldDbName);
    if (fs::exists(directory / world::kWorldFileName, ignored))
        return openWorldFile(directory / world::kWorldFileName);
    return fail(ErrorCode::NotFound, directory.string(),
                "neither world.db nor world.json is there; write one with limen world import");
}

} // namespace limen::cli
