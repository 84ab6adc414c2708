#pragma once

#include "dat/Codec.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

namespace limen::dat {

/// The header of a dat file (docs/formats/container.md#header), what a reader needs of it.
struct Header {
    std::uint32_t blockSize = 0, fileSize = 0, type = 0, subset = 0, root = 0;
    std::uint32_t engineVersion = 0, gameVersion = 0, minorVersion = 0;
};

/// A B-tree entry.
struct Entry {
    RecordId id = 0;
    std::uint16_t flags = 0; ///< bit 0: compressed
    std::uint16_t version = 0;
    std::uint32_t offset = 0, size = 0, date = 0;
    std::int32_t iteration = 0;
};

/// A dat file opened for reading: memory-mapped, nothing is read before it is asked for. All const members
/// may be called from several threads at once. Every rule of docs/formats/container.md#damage is checked where the
/// bytes are met, so a damaged node or chain gives an Error when it is touched, never a crash, a loop or a
/// large allocation.
class File {
public:
    /// Opens and checks the header and the root node. A pre-end-of-retail file (other magic, other header
    /// layout) is recognised and refused as Unsupported, with a sentence that says so.
    [[nodiscard]] static Result<File> open(const std::filesystem::path& path);
    /// The same over bytes already in memory (copied); `name` stands for the path in messages. For tests and
    /// fuzzing.
    [[nodiscard]] static Result<File> fromBytes(ByteView bytes, std::string name);

    File(File&&) noexcept;
    File& operator=(File&&) noexcept;
    ~File();

    [[nodiscard]] const Header& header() const;
    [[nodiscard]] const std::string& name() const;
    /// The role follows from header type and subset, not from the name.
    [[nodiscard]] FileRole role() const;

    /// The entry of `id`, or no value if the file does not hold it. Cost: a walk down the tree; <= 1 µs when
    /// warm.
    [[nodiscard]] Result<std::optional<Entry>> find(RecordId id) const;
    /// A record's payload: chain followed, decompressed. NotFound if absent. `scratch` holds the bytes when
    /// the record spans blocks or is compressed; the view is into it or into the mapping and lives as long as
    /// both.
    [[nodiscard]] Result<ByteView> read(const Entry& entry, Bytes& scratch) const;
    [[nodiscard]] Result<ByteView> read(RecordId id, Bytes& scratch) const;
    /// Calls `visit` for every entry in ascending order of id until it returns false. Checks the whole tree
    /// as it goes; what does not stop reading (leaves at unequal depths) is added to `warnings` when given.
    [[nodiscard]] Result<void> forEach(const std::function<bool(const Entry&)>& visit,
                                       std::vector<std::string>* warnings = nullptr) const;
    /// What was odd at opening but does not stop reading: a fileSize that differs from the real length.
    [[nodiscard]] const std::vector<std::string>& warnings() const;
    /// What was read of it counts as memory of this process no longer, though it is as valid as before; reading it again costs a little.
    /// For whoever has read much and now will not for a while. Safe while other threads read.
    void letPagesGo() const;

private:
    struct Impl;
    explicit File(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

} // namespace limen::dat
