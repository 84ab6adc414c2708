#include "engine/ViewRequest.h"

#include "core/Assert.h"
#include "core/Nearest.h"
#include "engine/WorldSource.h"
#include "world/Loader.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace limen::engine {
namespace {

const world::Place* placeNamed(const world::WorldFile& file, const std::string& name) {
    const auto found = std::find_if(file.places.begin(), file.places.end(),
                                    [&](const world::Place& p) { return p.name == name; });
    if (found != file.places.end())
        return &*found;
    const std::string plain = plainName(name);
    const auto similar = std::find_if(file.places.begin(), file.places.end(),
                                      [&](const world::Place& p) { return plainName(p.name) == plain; });
    return similar == file.places.end() ? nullptr : &*similar;
}

Result<const world::Place*> findPlace(const world::WorldFile& file, const std::string& name) {
    if (const world::Place* place = placeNamed(file, name))
        return place;
    if (file.places.empty())
        return fail(ErrorCode::NotFound, "--at",
                    fmt::format("unknown place '{}': this world has no places; give --eye X,Y,Z", name));
    std::vector<std::string> names;
    for (const world::Place& place : file.places)
        names.push_back(place.name);
    const std::vector<std::string> similar = nearest(name, names);
    constexpr std::size_t kListed = 12;
    const std::size_t count = names.size();
    names.resize(std::min(count, kListed));
    return fail(ErrorCode::NotFound, "--at",
                similar.empty()
                    ? fmt::format("unknown place '{}'; this world has {}{}. limen places lists all", name,
                                  fmt::join(names, ", "), count > kListed ? ", ..." : "")
                    : fmt::format("unknown place '{}'.{} limen places lists all", name, didYouMean(similar)));
}

Result<const world::Place*> startOf(const world::WorldFile& file) {
    if (const world::Place* first = firstPlace(file))
        return first;
    return fail(ErrorCode::NotFound, "--at", "this world names no place; give --at PLACE or --eye X,Y,Z");
}

RootChoice rootOf(const world::Place& place) {
    return place.cell == 0 ? RootChoice{RootChoice::Rule::Outside, 0}
                           : RootChoice{RootChoice::Rule::Cell, place.cell};
}

} // namespace

Result<ViewRequest> resolvePlace(ViewRequest request, const world::WorldFile& file) {
    if (!request.isAtStart && request.place.empty())
        return request;
    const Result<const world::Place*> place =
        request.isAtStart ? startOf(file) : findPlace(file, request.place);
    if (!place)
        return Failure(place.error());
    request.isAtStart = false;
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
    LIMEN_ASSERT(request.place.empty() && !request.isAtStart, "resolvePlace has filled in the place");
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

std::optional<ViewRequest> firstView(const WorldSource& source,
                                     const std::optional<RememberedPlace>& remembered) {
    if (remembered && isFinite(remembered->eye)) {
        const world::Place place{{}, remembered->eye, remembered->yaw, remembered->pitch, remembered->cell};
        const bool isThere =
            place.cell != 0
                ? source.archive.contains<dat::EnvCell>(place.cell)
                : source.archive.contains<dat::LandBlock>(dat::landBlockId(world::blockAt(place.eye)));
        if (isThere)
            return requestAt(place);
    }
    const world::Place* first = firstPlace(source.file);
    return first == nullptr ? std::nullopt : std::optional(requestAt(*first));
}

} // namespace limen::engine
