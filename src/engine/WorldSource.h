#pragma once

#include "engine/BuiltInWorld.h"
#include "cli/PlaceNotation.h"
#include "cli/ShotRequest.h"
#include "dat/Archive.h"
#include "world/Places.h"

#include <optional>

namespace limen::engine {

/// The files of one world, opened: the user's directory, or the built-in world in its cache.
struct WorldSource {
    std::optional<BuiltInWorld> builtIn; ///< keeps a borrowed directory alive
    dat::Archive archive;
    world::WorldFile file;
    std::string datOption; ///< "" or " --dat DIR", for command lines that are printed
};

/// Opens the dats of `directory`, or the built-in world when it is empty. Errors: the archive's, the world
/// file's; the built-in world cannot be written anywhere.
[[nodiscard]] Result<WorldSource> openWorldSource(const std::string& directory);

/// Where a view stands, before any of the world is loaded.
struct Viewpoint {
    Camera camera;
    bool onGround = false; ///< the eye's z is to be the ground's height plus kEyeHeight
    cli::RootChoice root;
    Vec3 player{0.0};
    /// The landblock to load around: the root cell's, else the eye's.
    dat::BlockCoord centre;
};

/// Resolves names of places. Errors: a name that the world does not know (some that it knows are in the
/// message).
[[nodiscard]] Result<Viewpoint> viewpointOf(const cli::ViewRequest& view, const world::WorldFile& file);

/// The place a world is first seen from: the one it names as its start, the first of its tour, the first of its places, else nothing.
[[nodiscard]] const world::Place* firstPlace(const world::WorldFile& file);

/// The standpoint of a named place.
[[nodiscard]] Viewpoint viewpointAt(const world::Place& place);

} // namespace limen::engine
