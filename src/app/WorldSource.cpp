#include "app/WorldSource.h"

#include "worlds/Demo.h"
#include "world/Loader.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace limen::app {
namespace {

constexpr dat::RecordId kHumanMale = 0x02000001; // setup (docs/uncertain.md)

Result<WorldSource> openDirectory(const std::filesystem::path& directory) {
    Result<dat::Archive> archive = dat::Archive::open(directory);
    if (!archive)
        return tl::unexpected(archive.error());
    Result<world::WorldFile> file = world::loadWorldFile(directory);
    if (!file)
        return tl::unexpected(file.error());
    // Files of the original game have no world.json: whoever walks there looks as its own people do.
    if (!std::filesystem::exists(directory / world::kWorldFileName) &&
        archive->contains<dat::Setup>(kHumanMale))
        file->moving.player = kHumanMale;
    return WorldSource{{}, std::move(*archive), std::move(*file), ""};
}

/// Opens the cached world; one that is damaged (a disk that was full, a stranger's file) is written anew,
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

dat::BlockCoord centreOf(const Viewpoint& stand) {
    return stand.root.kind == RootChoice::Kind::Cell ? dat::blockOf(stand.root.cell)
                                                     : world::blockAt(stand.camera.eye);
}

Result<const world::Place*> findPlace(const world::WorldFile& file, const std::string& name) {
    const auto found = std::find_if(file.places.begin(), file.places.end(),
                                    [&](const world::Place& p) { return p.name == name; });
    if (found != file.places.end())
        return &*found;
    if (file.places.empty())
        return fail(ErrorCode::NotFound, "--at",
                    fmt::format("'{}' is not known: this world's world.json names no places", name));
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min<std::size_t>(file.places.size(), 12); ++i)
        names.push_back(file.places[i].name);
    return fail(ErrorCode::NotFound, "--at",
                fmt::format("'{}' is not a place of this world, which knows {}{}", name,
                            fmt::join(names, ", "), file.places.size() > names.size() ? ", ..." : ""));
}

void applyNotation(const PlacePosition& place, Viewpoint& stand) {
    stand.camera.eye = place.eye;
    stand.camera.heading = {place.yaw.value_or(0.0), place.pitch.value_or(0.0)};
    stand.onGround = place.onGround;
    stand.root = place.root;
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

Viewpoint viewpointAt(const world::Place& place) {
    Viewpoint stand;
    stand.camera.eye = stand.player = place.eye;
    stand.camera.heading = {place.yaw, place.pitch};
    stand.root.kind = place.cell == 0 ? RootChoice::Kind::Outside : RootChoice::Kind::Cell;
    stand.root.cell = place.cell;
    stand.centre = centreOf(stand);
    return stand;
}

const world::Place* firstPlace(const world::WorldFile& file) {
    const auto start = std::find_if(file.places.begin(), file.places.end(),
                                    [&](const world::Place& place) { return place.name == file.start; });
    if (start != file.places.end() && !file.start.empty())
        return &*start;
    if (!file.tour.empty())
        return &file.tour.front();
    return file.places.empty() ? nullptr : &file.places.front();
}

Result<Viewpoint> viewpointOf(const ViewRequest& view, const world::WorldFile& file) {
    Viewpoint stand;
    if (view.eye)
        stand.camera.eye = *view.eye;
    else if (const auto* position = std::get_if<PlacePosition>(&*view.at))
        applyNotation(*position, stand);
    else {
        const Result<const world::Place*> place = findPlace(file, std::get<PlaceName>(*view.at).name);
        if (!place)
            return tl::unexpected(place.error());
        stand = viewpointAt(**place);
    }
    stand.camera.fovDegrees = view.fov;
    stand.camera.heading.yaw = view.yaw.value_or(stand.camera.heading.yaw);
    stand.camera.heading.pitch = view.pitch.value_or(stand.camera.heading.pitch);
    stand.root = view.root.value_or(stand.root);
    stand.player = view.player.value_or(stand.camera.eye);
    stand.centre = centreOf(stand);
    return stand;
}

} // namespace limen::app
