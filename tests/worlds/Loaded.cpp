#include "worlds/Loaded.h"

#include "dat/Archive.h"
#include "world/Loader.h"
#include "world/Places.h"
#include "worlds/Demo.h"
#include "worlds/builtin/land/TerrainShape.h"

#include <filesystem>
#include <unistd.h>

namespace limen::worlds::test {

const world::World& loaded() {
    static const world::World result = [] {
        const std::filesystem::path folder =
            std::filesystem::temp_directory_path() / ("limen_moving_test_" + std::to_string(::getpid()));
        world::World out;
        if (writeBuiltInWorld(folder).has_value()) {
            const auto archive = dat::Archive::open(folder);
            const auto file = world::loadWorldFile(folder);
            auto loading =
                world::loadWorld(*archive, kVillage, {}, file ? file->moving : world::MovingEntries());
            if (loading.has_value())
                out = std::move(*loading);
        }
        std::filesystem::remove_all(folder);
        return out;
    }();
    return result;
}

} // namespace limen::worlds::test
