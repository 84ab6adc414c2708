#pragma once

#include "TemporaryDirectory.h"

#include "dat/Archive.h"
#include "world/Places.h"
#include "worlds/Demo.h"

#include <optional>
#include <vector>

namespace limen::bench {

/// The built-in world's files in a temporary directory.
struct BuiltInFiles {
    TemporaryDirectory directory{"bench-world"};
    std::optional<dat::Archive> archive; ///< after `open`
    world::WorldFile world;

    /// Writes and opens the files. Errors: those of writing and reading.
    [[nodiscard]] Result<void> open() {
        return worlds::writeBuiltInWorld(directory.path())
            .and_then([&] { return dat::Archive::open(directory.path()); })
            .and_then([&](dat::Archive opened) {
                archive.emplace(std::move(opened));
                return world::loadWorldFile(directory.path());
            })
            .map([&](world::WorldFile read) { world = std::move(read); });
    }
};

/// `count` of the way points, spread evenly along the way; none if there are none.
[[nodiscard]] inline std::vector<world::Place> spreadEvenly(const std::vector<world::Place>& way,
                                                            std::size_t count) {
    std::vector<world::Place> places;
    for (std::size_t i = 0; i < count && !way.empty(); ++i)
        places.push_back(way[i * way.size() / count]);
    return places;
}

} // namespace limen::bench
