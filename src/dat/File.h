#pragma once

#include "dat/Codec.h"

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

namespace limen::dat {

/// The header of a dat file (docs/formats/container.md#header), without fields that readers ignore.
struct Header {
    std::uint32_t blockSize = 0, fileSize = 0, type = 0, subset = 0, root = 0;
    std::uint32_t engineVersion = 0, gameVersion = 0, minorVersion = 0;
    std::uint32_t firstFree = 0, lastFree = 0, freeCount = 0; ///< the list of free blocks
    std::uint32_t masterMap = 0;                              ///< a record id
    std::array<std::uint8_t, 16> majorVersion{};              ///< a GUID, as stored
};

/// A B-tree entry.
struct Entry {
    RecordId id = 0;
    std::uint16_t flags = 0; ///< bit 0: compressed
    std::uint16_t version = 0;
    std::uint32_t offset = 0, size = 0, date = 0;
    std::int32_t iteration = 0;
};

/// The shape of a file's B-tree.
struct IndexShape {
    std::uint32_t nodes = 0;
    int depth = 0; ///< nodes from the root to a leaf, both included
    std::vector<RecordId> rootKeys;
    std::vector<std::uint32_t> rootBranches; ///< offsets of nodes; empty if the root is a leaf
};

/// The list of free blocks, followed from the header's first one.
struct FreeList {
    std::uint32_t blocks = 0;
    std::string fault; ///< the reason why the list does not agree with the header; empty: it agrees
};

/// A memory-mapped dat file. Bytes are read on use. All const members may be called from several threads at
/// once. Every rule of docs/formats/container.md#damage is checked when the bytes are used: a damaged node or chain
/// gives an Error, never a crash, an endless loop or a large allocation.
class LIMEN_API File {
public:
    /// Opens the file and checks the header and the root node. Errors: Unsupported for a file from before the
    /// end of retail (other magic, other header layout); the message says so.
    [[nodiscard]] static Result<File> open(const std::filesystem::path& path);
    /// A file from a copy of bytes in memory; messages use `name` as its path. For tests and fuzzing.
    [[nodiscard]] static Result<File> fromBytes(ByteView bytes, std::string name);

    File(File&&) noexcept;
    File& operator=(File&&) noexcept;
    ~File();

    [[nodiscard]] const Header& header() const;
    [[nodiscard]] const std::string& name() const;
    /// The role follows from header type and subset, not from the name.
    [[nodiscard]] FileRole role() const;

    /// The entry of `id`, or no value if the file does not have it. Cost: one descent of the tree, at most 1
    /// µs when warm.
    [[nodiscard]] Result<std::optional<Entry>> find(RecordId id) const;
    /// A record's decompressed payload. `scratch` holds the bytes if the record spans blocks or is
    /// compressed. The view is into `scratch` or into the mapping and is valid as long as both are. Errors:
    /// NotFound if absent.
    [[nodiscard]] Result<ByteView> read(const Entry& entry, Bytes& scratch) const;
    [[nodiscard]] Result<ByteView> read(RecordId id, Bytes& scratch) const;
    /// Calls `visit` for every entry in ascending order of id until it returns false. Checks all nodes that
    /// it visits. Adds faults that do not prevent reading (leaves at unequal depths) to `warnings` if given,
    /// and writes the shape of the visited nodes to `shape` if given.
    [[nodiscard]] Result<void> forEach(const std::function<bool(const Entry&)>& visit,
                                       std::vector<std::string>* warnings = nullptr,
                                       IndexShape* shape = nullptr) const;
    /// Follows the list of free blocks. Readers ignore it, so a fault harms writers only.
    [[nodiscard]] FreeList freeList() const;
    /// The file's real length, bytes.
    [[nodiscard]] std::uint64_t length() const;
    /// Whether the first block of an entry's record is a block of this file, and its size fits into the file.
    [[nodiscard]] bool isInFile(const Entry& entry) const;
    /// Faults of the header that do not prevent reading: a fileSize that differs from the real length.
    [[nodiscard]] const std::vector<std::string>& warnings() const;
    /// Releases the pages that were read, so that they do not count as memory of this process. Views stay
    /// valid; the next read of a page costs a page fault. Call it after much was read. Safe while other
    /// threads read.
    void letPagesGo() const;
    /// Makes read() let the pages go each time that `bytes` were read. Each record counts 64 KiB more, for the pages that the
    /// system maps around it. 0, the default: never. Not safe while other threads read.
    void letPagesGoEvery(std::size_t bytes);

private:
    struct Impl;
    explicit File(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

} // namespace limen::dat
