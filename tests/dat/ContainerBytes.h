#pragma once

#include "dat/File.h"
#include "dat/Writer.h"

#include <cstring>
#include <gtest/gtest.h>

// Small files as bytes, changes to their words, and the errors of readers.
namespace limen::dat {

inline std::uint32_t wordAt(const Bytes& bytes, std::size_t offset) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + offset, sizeof word);
    return word;
}
inline void putWord(Bytes& bytes, std::size_t offset, std::uint32_t word) {
    std::memcpy(bytes.data() + offset, &word, sizeof word);
}

inline constexpr std::size_t kBlockSizeAt = 0x144, kFileSizeAt = 0x148, kTypeAt = 0x14C, kRootAt = 0x160;
inline constexpr std::size_t kNodeCountAt = 4 + 248; ///< in the first block of a portal node, behind the link
inline constexpr std::size_t kNodeEntriesAt = 4 + 252;

/// The offset of byte `logical` of a node in consecutive blocks.
inline std::size_t inNode(std::size_t node, std::size_t logical) {
    return node + logical / 1020 * 1024 + 4 + logical % 1020;
}

/// A portal file with `records` records of `size` bytes, ids 1, 2, 3 ...
inline Bytes portalFile(RecordId records, std::size_t size) {
    Writer writer(FileTraits::portal());
    for (RecordId id = 1; id <= records; ++id)
        writer.add(id, Bytes(size, static_cast<std::byte>(id)));
    return *writer.build();
}

inline Error openError(const Bytes& bytes) {
    const auto file = File::fromBytes(bytes, "bad.dat");
    EXPECT_FALSE(file);
    return file ? Error{} : file.error();
}

inline Error readError(const Bytes& bytes, RecordId id) {
    const auto file = File::fromBytes(bytes, "bad.dat");
    EXPECT_TRUE(file) << file.error().message();
    Bytes scratch;
    const auto payload = file ? file->read(id, scratch) : Failure(Error{});
    EXPECT_FALSE(payload);
    return payload ? Error{} : payload.error();
}

inline Error walkError(const Bytes& bytes) {
    const auto file = File::fromBytes(bytes, "bad.dat");
    EXPECT_TRUE(file) << file.error().message();
    if (!file)
        return {};
    const auto walked = file->forEach([](const Entry&) { return true; });
    EXPECT_FALSE(walked);
    return walked ? Error{} : walked.error();
}

/// Offset of the entry of `id` in a file whose only node is its root.
inline std::size_t entryAt(const Bytes& bytes, RecordId id) {
    return wordAt(bytes, kRootAt) + kNodeEntriesAt + (id - 1) * 24;
}

} // namespace limen::dat
