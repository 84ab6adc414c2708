#pragma once

#include "core/Api.h"

#include <cstdint>
#include <string>

namespace limen::dat {

/// A record's key in a dat's B-tree. The high byte (portal files) or the low word (cell files) determines the
/// type: see docs/formats/ids.md.
using RecordId = std::uint32_t;

inline constexpr RecordId kIterationId = 0xFFFF0001u;
inline constexpr RecordId kRegionId = 0x13000000u;

/// Kinds of record that Limen decodes. `Other`: only its bytes are available.
enum class RecordKind {
    GfxObj,
    Setup,
    Animation,
    Palette,
    SurfaceTexture,
    RenderSurface,
    Surface,
    MotionTable,
    Environment,
    PaletteSet,
    ClothingTable,
    DegradeInfo,
    Scene,
    Region,
    ParticleEmitter,
    PhysicsScript,
    PhysicsScriptTable,
    LandBlock,
    LandBlockInfo,
    EnvCell,
    Iteration,
    Other
};

/// The meaning of an id depends on the file: a portal (or highres, local) file or a cell file.
enum class FileRole { Portal, Cell, Highres, Local };

[[nodiscard]] LIMEN_API RecordKind kindOf(FileRole role, RecordId id);
/// Whether records of this kind are in the cell file.
[[nodiscard]] constexpr bool isOfCells(RecordKind kind) {
    return kind == RecordKind::LandBlock || kind == RecordKind::LandBlockInfo || kind == RecordKind::EnvCell;
}
[[nodiscard]] LIMEN_API const char* nameOf(RecordKind kind);
/// "0x%08X".
[[nodiscard]] LIMEN_API std::string idText(RecordId id);

/// A landblock's position on the map, 0..254: x increases to the east, y to the north.
struct BlockCoord {
    int x = 0;
    int y = 0;
    friend bool operator==(const BlockCoord&, const BlockCoord&) = default;
};

[[nodiscard]] constexpr RecordId blockWord(BlockCoord b) {
    return (static_cast<RecordId>(b.x) << 24) | (static_cast<RecordId>(b.y) << 16);
}
[[nodiscard]] constexpr BlockCoord blockOf(RecordId cellFileId) {
    return {static_cast<int>(cellFileId >> 24), static_cast<int>((cellFileId >> 16) & 0xFF)};
}
[[nodiscard]] constexpr RecordId landBlockId(BlockCoord b) {
    return blockWord(b) | 0xFFFFu;
}
[[nodiscard]] constexpr RecordId landBlockInfoId(BlockCoord b) {
    return blockWord(b) | 0xFFFEu;
}

/// Low words of cell ids.
inline constexpr std::uint16_t kFirstCell = 0x0100;
inline constexpr std::uint16_t kLastCell = 0xFFFD;
inline constexpr std::uint16_t kOutdoors = 0xFFFF; ///< in a portal's otherCellId: the outside
inline constexpr std::uint16_t kNoPortal = 0xFFFF; ///< in otherPortalId: one-way

} // namespace limen::dat
