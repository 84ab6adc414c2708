#include "engine/OpenedWorld.h"

#include "core/Nearest.h"
#include "engine/WorldSource.h"

#include <fmt/format.h>
#include <utility>

namespace limen::engine {
namespace {

Viewpoint viewpointOf(const ViewRequest& view) {
    Viewpoint found{view.eye, view.yaw.value_or(0.0), view.pitch.value_or(0.0), std::nullopt};
    if (view.root && view.root->rule != RootChoice::Rule::Auto)
        found.cell = view.root->cell;
    return found;
}

/// The errors of resolvePlace() name options of the command line.
Failure unknownPlace(std::string_view place, const std::vector<std::string>& names) {
    const std::vector<std::string> similar = nearest(place, names);
    return fail(ErrorCode::NotFound, std::string(place),
                names.empty() ? "unknown place; this world has no places: give a position"
                              : fmt::format("unknown place; this world has {} places.{}", names.size(),
                                            didYouMean(similar)));
}

} // namespace

Result<OpenedWorld> OpenedWorld::open(const std::string& path) {
    return openWorldSource(path).map([](WorldSource&& source) {
        return OpenedWorld(std::make_shared<const WorldSource>(std::move(source)));
    });
}

std::vector<std::string> OpenedWorld::places() const {
    std::vector<std::string> names;
    for (const world::Place& place : source_->file.places)
        names.push_back(place.name);
    return names;
}

Result<Viewpoint> OpenedWorld::viewpoint(std::string_view place) const {
    ViewRequest request;
    request.place = place;
    if (place.empty())
        return unknownPlace(place, places());
    const Result<ViewRequest> resolved = resolvePlace(request, *source_);
    if (resolved)
        return viewpointOf(*resolved);
    return resolved.error().code == ErrorCode::NotFound ? unknownPlace(place, places())
                                                        : Failure(resolved.error());
}

Result<Viewpoint> OpenedWorld::start() const {
    const world::Place* first = firstPlace(source_->file);
    if (first == nullptr)
        return fail(ErrorCode::NotFound, "start", "this world names no place; give a position");
    return viewpointOf(requestAt(*first));
}

} // namespace limen::engine
