#pragma once

#include "dat/Codec.h"

#include <filesystem>
#include <map>
#include <optional>

namespace limen::dat {

/// The header fields of a new file.
struct LIMEN_API FileTraits {
    std::uint32_t blockSize = 1024;
    std::uint32_t type = 1; ///< 1 portal, 2 cell, 3 local
    std::uint32_t subset = 0;
    std::uint32_t engineVersion = 110, gameVersion = 0, minorVersion = 6657;

    [[nodiscard]] static FileTraits portal();
    [[nodiscard]] static FileTraits cell();
    [[nodiscard]] static FileTraits highres();
    [[nodiscard]] static FileTraits local();
};

/// Collects records and writes a complete dat file (docs/formats/container.md#writing-a-file). The bytes depend on the records
/// only: dates and iterations are fixed unless given. Errors of `build` and `write`: BadArgument for the first record that
/// cannot be encoded (Codec.h) or compressed (64 MiB), a block size that is no power of two from 64 to 65,536, and a file of
/// 2 GiB or more.
class LIMEN_API Writer {
public:
    explicit Writer(FileTraits traits) : traits_(traits) {}

    /// Adds or replaces a record. `compressed` stores it as a zlib stream with flag bit 0.
    void add(RecordId id, Bytes payload, bool compressed = false);
    template <class Record>
    void add(const Record& record) {
        addEncoded(record.id, encode(record));
    }
    void add(RecordId id, const Surface& surface) { addEncoded(id, encode(surface)); }

    /// The whole file. The iteration record is added if it is missing.
    [[nodiscard]] Result<Bytes> build() const;
    /// Writes the file to a second name and renames it, so that no reader sees a partial file.
    [[nodiscard]] Result<void> write(const std::filesystem::path& path) const;

private:
    struct Stored {
        Bytes bytes;
        bool compressed = false;
    };
    void addEncoded(RecordId id, Result<Bytes> encoded);
    void refuse(Error fault);

    FileTraits traits_;
    std::map<RecordId, Stored> records_;
    std::optional<Error> fault_; ///< the first one
};

} // namespace limen::dat
