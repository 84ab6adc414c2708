#pragma once

#include "dat/codec/ByteReader.h"
#include "dat/codec/ByteWriter.h"

#include <fmt/format.h>

// The base of every codec: one function `layout(io, record)` for each record type. It is called with a
// ByteReader and a Record&, or with a ByteWriter and a const Record&, so reading and writing always agree.
namespace limen::dat {

/// Reads or writes a record's stored id, which must be its key.
inline void ownId(ByteReader& io, RecordId key, RecordId& id) {
    io.value(id);
    if (id != key && !io.failed())
        io.failAt(io.offset() - sizeof id, fmt::format("the record stores another id, 0x{:08X}", id));
}
inline void ownId(ByteWriter& io, RecordId, const RecordId& id) {
    io.value(id);
}

/// Decodes a whole payload with `read(reader, record)`, which must consume all bytes.
template <class Record, class Read>
[[nodiscard]] Result<Record> decodeWith(RecordId id, ByteView payload, Read&& read) {
    ByteReader io(payload);
    Result<Record> out{std::in_place};
    read(io, *out);
    if (!io.failed() && io.remaining() != 0)
        io.fail(fmt::format("the record ends here by its layout, but {} bytes follow", io.remaining()));
    if (io.failed()) {
        out = fail(io.failureCode(), fmt::format("record 0x{:08X}, offset 0x{:X}", id, io.failureOffset()),
                   io.failureReason());
    }
    return out;
}

template <class IO, class F>
void frame(IO& io, F& f) {
    io.value(f.origin);
    io.value(f.orientation);
}
template <class IO, class P>
void plane(IO& io, P& p) {
    io.value(p.n);
    io.value(p.d);
}
template <class IO, class S>
void sphere(IO& io, S& s) {
    io.value(s.centre);
    io.value(s.radius);
}
template <class IO, class C>
void colour(IO& io, C& c) {
    io.value(c.argb);
}
template <class IO, class S>
void stab(IO& io, S& s) {
    io.value(s.model);
    frame(io, s.frame);
}
/// A count and its plain values.
template <class Count, class IO, class List>
void values(IO& io, List& list, const char* what) {
    io.template list<Count>(list, sizeof(typename std::remove_const_t<List>::value_type), what,
                            [&](auto& one) { io.value(one); });
}

/// A "PackableHashTable" of items of at least `minValueBytes` without their keys (docs/formats/primitives.md).
template <class Value, class Item>
void hashTable(ByteReader& io, PackedHashTable<Value>& table, std::size_t minValueBytes, const char* what,
               Item&& item) {
    const std::size_t count = io.count<std::uint16_t>(what);
    io.value(table.buckets);
    io.items(table.entries, count, 4 + minValueBytes, what, [&](auto& entry) {
        io.value(entry.first);
        item(entry.second);
    });
}
template <class Value, class Item>
void hashTable(ByteWriter& io, const PackedHashTable<Value>& table, std::size_t, const char*, Item&& item) {
    io.count<std::uint16_t>(table.entries.size());
    io.value(table.buckets);
    for (const auto& [key, value] : table.entries) {
        io.value(key);
        item(value);
    }
}

inline constexpr std::size_t kFrameBytes = 28;
inline constexpr std::size_t kStabBytes = 4 + kFrameBytes;

} // namespace limen::dat
