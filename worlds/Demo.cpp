#include "worlds/Demo.h"

#include "worlds/BuiltInWorld.h"
#include "worlds/records/WorldFiles.h"

namespace limen::worlds {

Result<void> writeBuiltInWorld(const std::filesystem::path& directory) {
    return writeWorldFiles(buildBuiltInWorld(), directory);
}

} // namespace limen::worlds
