#include "engine/ViewRequest.h"

#include "core/Assert.h"
#include "world/Loader.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace limen::engine {
namespace {

Result<const world::Place*> findPlace(const world::WorldFile& file, const std::string& name) {
    const auto found = std::find_if(file.places.begin(), file.places.end(),
                                    [&](const world::Place& p) { return p.name == name; });
    if (found != file.places.end())
        return &*found;
    if (file.places.empty())
        return fail(
            ErrorCode::NotFound, "--at",
            fmt::format("unknown place '{}': this world's world.json names no places; give --eye X,Y,Z",
                        name));
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min<std::size_t>(file.places.size(), 12); ++i)
        names.push_back(file.places[i].name);
    return fail(ErrorCode::NotFound, "--at",
                fmt::format("unknown place '{}'; this world has {}{}", name, fmt::join(names, ", "),
                            file.places.size() > names.size() ? ", ..." : ""));
}

RootChoice rootOf(const world::Place& place) {
    return place.cell == 0 ? RootChoice{RootChoice::Rule::Outside, 0}
                           : RootChoice{RootChoice::Rule::Cell, place.cell};
}

} // namespace

Result<ViewRequest> resolvePlace(ViewRequest request, const world::WorldFile& file) {
    if (request.place.empty())
        return request;
    const Result<const world::Place*> place = findPlace(file, request.place);
    if (!place)
        return tl::unexpected(place.error());
    request.place.clear();
    request.eye = (*place)->eye;
    request.isOnGround = false;
    request.yaw = request.yaw.value_or((*place)->yaw);
    request.pitch = request.pitch.value_or((*place)->pitch);
    request.root = request.root.value_or(rootOf(**place));
    return request;
}

ViewRequest requestAt(const world::Place& place) {
    ViewRequest request;
    request.eye = place.eye;
    request.yaw = place.yaw;
    request.pitch = place.pitch;
    request.root = rootOf(place);
    return request;
}

dat::BlockCoord centreOf(const ViewRequest& request) {
    LIMEN_ASSERT(request.place.empty(), "resolvePlace has filled in the place");
    return request.root && request.root->rule == RootChoice::Rule::Cell ? dat::blockOf(request.root->cell)
                                                                        : world::blockAt(request.eye);
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

} // namespace limen::engine
