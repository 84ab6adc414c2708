#include "dat/codec/Layout.h"

namespace limen::dat {
namespace {

constexpr std::size_t kTextureChangeBytes = 8, kPaletteRangeBytes = 8;
constexpr std::size_t kMinPartChangeBytes = 12, kMinPaletteChangeBytes = 8;

template <class IO, class S>
void paletteSet(IO& io, RecordId key, S& s) {
    ownId(io, key, s.id);
    values<std::uint32_t>(io, s.palettes, "palettes");
}

template <class IO, class P>
void partChange(IO& io, P& p) {
    io.value(p.part);
    io.value(p.gfxObj);
    io.template list<std::uint32_t>(p.textures, kTextureChangeBytes, "changed textures", [&](auto& change) {
        io.value(change.from);
        io.value(change.to);
    });
}

template <class IO, class P>
void paletteChange(IO& io, P& p) {
    io.template list<std::uint32_t>(p.ranges, kPaletteRangeBytes, "ranges of a palette", [&](auto& range) {
        io.value(range.offset);
        io.value(range.count);
    });
    io.value(p.palettes);
}

template <class IO, class T>
void clothingTable(IO& io, RecordId key, T& t) {
    ownId(io, key, t.id);
    hashTable(io, t.parts, 4, "clothed models", [&](auto& changes) {
        io.template list<std::uint32_t>(changes, kMinPartChangeBytes, "changed parts",
                                        [&](auto& change) { partChange(io, change); });
    });
    hashTable(io, t.palettes, 8, "palette templates", [&](auto& one) {
        io.value(one.icon);
        io.template list<std::uint32_t>(one.changes, kMinPaletteChangeBytes, "changed palettes",
                                        [&](auto& change) { paletteChange(io, change); });
    });
}

} // namespace

template <>
Result<PaletteSet> decode<PaletteSet>(RecordId id, ByteView payload) {
    return decodeWith<PaletteSet>(id, payload, [&](ByteReader& io, PaletteSet& s) { paletteSet(io, id, s); });
}
template <>
Result<Bytes> encode<PaletteSet>(const PaletteSet& s) {
    ByteWriter io;
    paletteSet(io, s.id, s);
    return io.take(s.id);
}

template <>
Result<ClothingTable> decode<ClothingTable>(RecordId id, ByteView payload) {
    return decodeWith<ClothingTable>(id, payload,
                                     [&](ByteReader& io, ClothingTable& t) { clothingTable(io, id, t); });
}
template <>
Result<Bytes> encode<ClothingTable>(const ClothingTable& t) {
    ByteWriter io;
    clothingTable(io, t.id, t);
    return io.take(t.id);
}

} // namespace limen::dat
