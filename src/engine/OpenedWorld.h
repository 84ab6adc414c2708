#pragma once

#include "core/Error.h"
#include "geometry/Vec.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// A world for other projects (docs/tutorials/engine.md). FrameDrawer.h draws it.
namespace limen::engine {

struct WorldSource;

/// An eye in a world. Positions are global: metres from the south-west corner of the map, x to the east, y to the north, z up.
struct Viewpoint {
    Vec3 eye{0.0};
    double yaw = 0.0;   ///< degrees; 0 looks north, 90 east
    double pitch = 0.0; ///< degrees; 90 looks straight up
    /// The space that contains the eye: the record id of a cell, or 0 for the outside. None: found from the position. Where
    /// cells overlap, several contain one position, and the id decides.
    std::optional<std::uint32_t> cell{};
};

/// The files of one world, open for reading. Copies share the files. Several threads may use one object.
class LIMEN_API OpenedWorld {
public:
    /// Opens the dat files at `path`: a directory, one of its files, or a directory above it. Empty: the built-in world,
    /// which is first written to the user's cache ($XDG_CACHE_HOME/limen, else ~/.cache/limen), or else to a temporary
    /// directory. Cost: a second for the built-in world when it is written; for other files without `world.json`, seconds
    /// when their places are searched for the first time.
    /// Errors: NotFound, Unreadable, Malformed.
    [[nodiscard]] static Result<OpenedWorld> open(const std::string& path = {});

    /// The names of its places, in the order of `world.json` or of the search. May be empty.
    [[nodiscard]] std::vector<std::string> places() const;
    /// The viewpoint at a place. Upper and lower case, blanks and hyphens do not matter. In a world with placed objects, the
    /// name of an object is a place, too. Errors: NotFound, with similar names; Malformed for a damaged `world.db`.
    [[nodiscard]] Result<Viewpoint> viewpoint(std::string_view place) const;
    /// The viewpoint at which the world begins. Errors: NotFound for a world without places.
    [[nodiscard]] Result<Viewpoint> start() const;

    /// Internal.
    [[nodiscard]] const std::shared_ptr<const WorldSource>& source() const { return source_; }

private:
    explicit OpenedWorld(std::shared_ptr<const WorldSource> source) : source_(std::move(source)) {}

    std::shared_ptr<const WorldSource> source_;
};

} // namespace limen::engine
