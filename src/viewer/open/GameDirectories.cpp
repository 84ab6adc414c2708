#include "viewer/open/GameDirectories.h"

#if __has_include("engine/DatDirectory.h")
#include "engine/DatDirectory.h"
#define LIMEN_HAS_DAT_DIRECTORY
#endif

namespace limen::viewer {

std::vector<std::filesystem::path> gameDirectories() {
#ifdef LIMEN_HAS_DAT_DIRECTORY
    return engine::knownGameDirectories();
#else
    return {};
#endif
}

} // namespace limen::viewer
