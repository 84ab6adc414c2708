#include "viewer/open/GameDirectories.h"

#include "engine/DatDirectory.h"

namespace limen::viewer {

std::vector<std::filesystem::path> gameDirectories() {
    return engine::knownGameDirectories();
}

} // namespace limen::viewer
