#include "dat/codec/Layout.h"

namespace limen::dat {
namespace {

constexpr std::size_t kMinBuildingBytes = 4 + kFrameBytes + 4 + 4;
constexpr std::size_t kMinBuildingPortalBytes = 8;

struct EnvCellCounts {
    std::size_t surfaces = 0, portals = 0, visibleCells = 0;
};

EnvCellCounts cellCounts(ByteReader& io, EnvCell&) {
    EnvCellCounts n;
    n.surfaces = io.count<std::uint8_t>("surfaces");
    n.portals = io.count<std::uint8_t>("portals");
    n.visibleCells = io.count<std::uint16_t>("visible cells");
    return n;
}
EnvCellCounts cellCounts(ByteWriter& io, const EnvCell& cell) {
    io.count<std::uint8_t>(cell.surfaces.size());
    io.count<std::uint8_t>(cell.portals.size());
    io.count<std::uint16_t>(cell.visibleCells.size());
    return {cell.surfaces.size(), cell.portals.size(), cell.visibleCells.size()};
}

/// The second copy of an EnvCell's id.
void idAgain(ByteReader& io, const EnvCell& cell) {
    const auto again = io.get<std::uint32_t>();
    if (again != cell.id && !io.failed())
        io.failAt(io.offset() - sizeof again, fmt::format("the record repeats its id as 0x{:08X}", again));
}
void idAgain(ByteWriter& io, const EnvCell& cell) {
    io.value(cell.id);
}

template <class IO, class C>
void envCell(IO& io, RecordId key, C& cell) {
    ownId(io, key, cell.id);
    io.value(cell.flags);
    idAgain(io, cell);
    const EnvCellCounts n = cellCounts(io, cell);
    io.array(cell.surfaces, n.surfaces);
    io.value(cell.environment);
    io.value(cell.cellStructure);
    frame(io, cell.position);
    static_assert(sizeof(CellPortal) == 8 && offsetof(CellPortal, otherPortalId) == 6, "stored as four u16");
    io.array(cell.portals, n.portals);
    io.array(cell.visibleCells, n.visibleCells);
    if (cell.flags & EnvCell::kHasStatics)
        io.template list<std::uint32_t>(cell.statics, kStabBytes, "statics", [&](auto& s) { stab(io, s); });
    if (cell.flags & EnvCell::kHasRestriction)
        io.value(cell.restriction);
}

template <class IO, class B>
void landBlock(IO& io, RecordId key, B& block) {
    ownId(io, key, block.id);
    io.value(block.hasObjects);
    for (auto& word : block.terrain)
        io.value(word);
    for (auto& height : block.heights)
        io.value(height);
    io.value(block.padding);
}

template <class IO, class P>
void buildingPortal(IO& io, P& portal) {
    io.value(portal.flags);
    io.value(portal.otherCellId);
    io.value(portal.otherPortalId);
    values<std::uint16_t>(io, portal.stabs, "stabs");
    io.align(portal.padding);
}

template <class IO, class B>
void building(IO& io, B& one) {
    io.value(one.model);
    frame(io, one.frame);
    io.value(one.numLeaves);
    io.template list<std::uint32_t>(one.portals, kMinBuildingPortalBytes, "building portals",
                                    [&](auto& portal) { buildingPortal(io, portal); });
}

/// The number of buildings is before hasRestrictions, the buildings are behind it.
void buildings(ByteReader& io, LandBlockInfo& info) {
    const auto count = io.count<std::uint16_t>("buildings");
    io.value(info.hasRestrictions);
    io.items(info.buildings, count, kMinBuildingBytes, "buildings",
             [&](Building& one) { building(io, one); });
}
void buildings(ByteWriter& io, const LandBlockInfo& info) {
    io.count<std::uint16_t>(info.buildings.size());
    io.value(info.hasRestrictions);
    for (const Building& one : info.buildings)
        building(io, one);
}

void restrictions(ByteReader& io, LandBlockInfo& info) {
    const auto count = io.count<std::uint16_t>("restrictions");
    io.value(info.restrictionBuckets);
    io.items(info.restrictions, count, 8, "restrictions", [&](auto& pair) {
        io.value(pair.first);
        io.value(pair.second);
    });
}
void restrictions(ByteWriter& io, const LandBlockInfo& info) {
    io.count<std::uint16_t>(info.restrictions.size());
    io.value(info.restrictionBuckets);
    for (const auto& [cell, object] : info.restrictions) {
        io.value(cell);
        io.value(object);
    }
}

template <class IO, class I>
void landBlockInfo(IO& io, RecordId key, I& info) {
    ownId(io, key, info.id);
    io.value(info.numCells);
    io.template list<std::uint32_t>(info.objects, kStabBytes, "objects", [&](auto& s) { stab(io, s); });
    buildings(io, info);
    if (info.hasRestrictions != 0)
        restrictions(io, info);
}

} // namespace

template <>
Result<EnvCell> decode<EnvCell>(RecordId id, ByteView payload) {
    return decodeWith<EnvCell>(id, payload, [&](ByteReader& io, EnvCell& cell) { envCell(io, id, cell); });
}
template <>
Result<Bytes> encode<EnvCell>(const EnvCell& cell) {
    ByteWriter io;
    io.require((cell.flags & EnvCell::kHasStatics) || cell.statics.empty(), "statics need kHasStatics");
    envCell(io, cell.id, cell);
    return io.take(cell.id);
}

template <>
Result<LandBlock> decode<LandBlock>(RecordId id, ByteView payload) {
    return decodeWith<LandBlock>(id, payload,
                                 [&](ByteReader& io, LandBlock& block) { landBlock(io, id, block); });
}
template <>
Result<Bytes> encode<LandBlock>(const LandBlock& block) {
    ByteWriter io;
    landBlock(io, block.id, block);
    return io.take(block.id);
}

template <>
Result<LandBlockInfo> decode<LandBlockInfo>(RecordId id, ByteView payload) {
    return decodeWith<LandBlockInfo>(
        id, payload, [&](ByteReader& io, LandBlockInfo& info) { landBlockInfo(io, id, info); });
}
template <>
Result<Bytes> encode<LandBlockInfo>(const LandBlockInfo& info) {
    ByteWriter io;
    io.require(info.hasRestrictions != 0 || info.restrictions.empty(), "restrictions need hasRestrictions");
    landBlockInfo(io, info.id, info);
    return io.take(info.id);
}

} // namespace limen::dat
