#pragma once

#include "dat/Archive.h"
#include "support/LoadTestWorld.h"
#include "world/Places.h"
#include "worlds/Generated.h"

#include <string>

namespace limen::worlds::test {

/// A generated world as files, loaded block by block.
class GeneratedWorld {
public:
    explicit GeneratedWorld(const GeneratedSpec& spec);

    [[nodiscard]] const GeneratedSpec& spec() const { return spec_; }
    [[nodiscard]] const std::filesystem::path& directory() const { return directory_.path(); }
    [[nodiscard]] const dat::Archive& archive() const { return *archive_; }
    [[nodiscard]] const world::WorldFile& file() const { return file_; }
    /// All existing landblocks, in ascending order of id.
    [[nodiscard]] const std::vector<dat::BlockCoord>& blocks() const { return blocks_; }
    /// Loads the block and its neighbours up to `radius`.
    [[nodiscard]] world::World load(dat::BlockCoord block, bool mergeZones = true, int radius = 0) const;

private:
    GeneratedSpec spec_;
    limen::test::TempDir directory_;
    std::optional<dat::Archive> archive_;
    world::WorldFile file_;
    std::vector<dat::BlockCoord> blocks_;
};

/// "dungeon of 20, seed 3"
[[nodiscard]] std::string nameOf(const GeneratedSpec& spec);

/// The number of cells that can be reached from the outside and from cell `from`.
[[nodiscard]] std::size_t reachedFrom(const world::World& world, world::SpaceIndex from);

} // namespace limen::worlds::test
