#pragma once

#include "dat/File.h"

// Whether files hold what they should: for people who doubt theirs, and for us.
namespace limen::dat {

/// Something that is not as it should be.
struct Fault {
    enum class Kind : std::uint8_t {
        Unreadable, ///< its bytes cannot be had, or are no such record
        Changed,    ///< it would not be written back as the same bytes
        Unresolved  ///< it names a record, or a place in one, that is not there
    };
    Kind kind = Kind::Unreadable;
    FileRole role = FileRole::Portal;
    RecordId id = 0;
    std::string what;
};
[[nodiscard]] const char* nameOf(Fault::Kind kind);

struct VerifyReport {
    struct Sum {
        std::uint64_t records = 0, bytes = 0;
    };
    std::array<Sum, static_cast<std::size_t>(RecordKind::Other) + 1> byKind{}; ///< bytes of payloads
    std::array<std::uint64_t, 3> faultCounts{};                                ///< by Fault::Kind
    std::vector<Fault> faults;         ///< the first so many, in the order of files and ids
    std::vector<std::string> warnings; ///< of files as a whole

    [[nodiscard]] bool isClean() const { return faultCounts[0] + faultCounts[1] + faultCounts[2] == 0; }
};

struct VerifyOptions {
    std::size_t mostFaults = 1000; ///< that are kept; all are counted
    /// Told after each record: how many there are, and how many are done.
    std::function<void(std::size_t total, std::size_t done)> progress;
};

/// Reads every record, decodes those of RecordTypes, encodes them again and compares, and looks up every reference
/// (References.h); of cells also their shape in its Environment, and the portals that portals name. A reference into a
/// file that is not among `files` is not judged. Each role once. Memory: 32 bytes a record, and the portals of all shapes.
[[nodiscard]] VerifyReport verify(std::span<const File* const> files, const VerifyOptions& options = {});

} // namespace limen::dat
