#include "worlds/GeneratedWorlds.h"

#include <fmt/format.h>

namespace limen::worlds::test {

GeneratedWorld::GeneratedWorld(const GeneratedSpec& spec) : spec_(spec) {
    const Result<void> written = writeGeneratedWorld(spec, directory());
    EXPECT_TRUE(written) << (written ? "" : written.error().message());
    Result<dat::Archive> archive = dat::Archive::open(directory());
    if (!archive) {
        ADD_FAILURE() << archive.error().message();
        return;
    }
    archive_ = std::move(*archive);
    Result<world::WorldFile> file = world::loadWorldFile(directory());
    EXPECT_TRUE(file) << (file ? "" : file.error().message());
    if (file)
        file_ = std::move(*file);
    for (int x = 0; x < 255; ++x) {
        for (int y = 0; y < 255; ++y)
            if (archive_->contains<dat::LandBlock>(dat::landBlockId({x, y})))
                blocks_.push_back({x, y});
    }
}

world::World GeneratedWorld::load(dat::BlockCoord block, bool mergeZones, int radius) const {
    Result<world::World> loaded = world::loadWorld(archive(), block, {radius, mergeZones}, file_.moving);
    if (!loaded) {
        ADD_FAILURE() << loaded.error().message();
        return {};
    }
    return std::move(*loaded);
}

std::string nameOf(const GeneratedSpec& spec) {
    constexpr const char* kNames[] = {"dungeon", "town",   "complex", "terrain",
                                      "map",     "skewed", "thin",    "nested"};
    return fmt::format("{} of {}, seed {}", kNames[static_cast<std::size_t>(spec.kind)], spec.size,
                       spec.seed);
}

std::size_t reachedFrom(const world::World& world, world::SpaceIndex from) {
    std::vector<bool> seen(world.spaces.size(), false);
    std::vector<world::SpaceIndex> found{from};
    seen[from] = true;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const world::Space& space = world.spaces[found[i]];
        for (std::uint32_t p = space.firstPortal; p < space.firstPortal + space.portalCount; ++p) {
            const world::SpaceIndex next = world.portals[p].destination;
            if (next != world::kNone && !seen[next]) {
                seen[next] = true;
                found.push_back(next);
            }
        }
    }
    return found.size() - (seen[world::kOutside] ? 1 : 0);
}

} // namespace limen::worlds::test
