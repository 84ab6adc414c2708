#include "worlds/Generated.h"

#include "worlds/generate/GeneratedKinds.h"
#include "worlds/records/WorldFiles.h"

namespace limen::worlds {

namespace {

std::uint32_t largest(GeneratedKind kind) {
    switch (kind) {
    case GeneratedKind::Dungeon:
        return 1000000;
    case GeneratedKind::Town:
        return 2000;
    case GeneratedKind::Complex:
    case GeneratedKind::Skewed:
        return 5000;
    case GeneratedKind::Thin:
        return 400;
    case GeneratedKind::Nested:
        return 2000;
    case GeneratedKind::Map:
        return 1000000;
    case GeneratedKind::Terrain:
        break;
    }
    return 500;
}

WorldRecords build(const GeneratedSpec& spec) {
    switch (spec.kind) {
    case GeneratedKind::Dungeon:
        return buildDungeon(spec);
    case GeneratedKind::Town:
        return buildTown(spec);
    case GeneratedKind::Complex:
        return buildComplex(spec);
    case GeneratedKind::Map:
        return buildMap(spec);
    case GeneratedKind::Skewed:
        return buildSkewed(spec);
    case GeneratedKind::Thin:
        return buildThin(spec);
    case GeneratedKind::Nested:
        return buildNested(spec);
    case GeneratedKind::Terrain:
        break;
    }
    return buildTerrainWorld(spec);
}

} // namespace

Result<void> writeGeneratedWorld(const GeneratedSpec& spec, const std::filesystem::path& directory) {
    if (spec.size < 1 || spec.size > largest(spec.kind)) {
        return fail(ErrorCode::BadArgument, "size",
                    "a world of this kind takes a size of 1 to " + std::to_string(largest(spec.kind)));
    }
    if (!(spec.overlapShare >= 0.0 && spec.overlapShare <= 0.05))
        return fail(ErrorCode::BadArgument, "overlap share", "must be between 0 and 0.05");
    return writeWorldFiles(build(spec), directory);
}

} // namespace limen::worlds
