#include "engine/WorldSource.h"

#include "worlds/Demo.h"

namespace limen::engine {
namespace {

constexpr dat::RecordId kHumanMale = 0x02000001; // setup (docs/uncertain.md)

Result<WorldSource> openDirectory(const std::filesystem::path& directory) {
    Result<dat::Archive> archive = dat::Archive::open(directory);
    if (!archive)
        return tl::unexpected(archive.error());
    Result<world::WorldFile> file = world::loadWorldFile(directory);
    if (!file)
        return tl::unexpected(file.error());
    // The original game's files have no world.json. The player's body is then the game's human male.
    if (!std::filesystem::exists(directory / world::kWorldFileName) &&
        archive->contains<dat::Setup>(kHumanMale))
        file->moving.player = kHumanMale;
    return WorldSource{{}, std::move(*archive), std::move(*file), ""};
}

/// Opens the cached world. If it is damaged (by a full disk, or by another program), it is written again,
/// once.
Result<WorldSource> openBuiltIn() {
    const std::string key = programKey();
    for (int attempt = 0;; ++attempt) {
        Result<BuiltInWorld> builtIn = openBuiltInWorld(cacheRoot(), key, worlds::writeBuiltInWorld);
        if (!builtIn)
            return tl::unexpected(builtIn.error());
        Result<WorldSource> source = openDirectory(builtIn->directory());
        if (source)
            source->builtIn = std::move(*builtIn);
        if (source || attempt == 1)
            return source;
        discardBuiltInWorld(*builtIn);
    }
}

} // namespace

Result<WorldSource> openWorldSource(const std::string& directory) {
    if (directory.empty())
        return openBuiltIn();
    Result<WorldSource> source = openDirectory(directory);
    if (source)
        source->datOption = " --dat '" + directory + "'";
    return source;
}

} // namespace limen::engine
