#include "demo/Demo.h"

#include "demo/BuiltInWorld.h"
#include "demo/WorldFiles.h"

namespace limen::demo {

Result<void> writeBuiltInWorld(const std::filesystem::path& directory) {
    return writeWorldFiles(buildBuiltInWorld(), directory);
}

} // namespace limen::demo
