#pragma once

#include "dat/File.h"

// Checks whole files: every record decodes, encodes to the same bytes, and names existing records.
namespace limen::dat {

enum class FaultKind : std::uint8_t {
    Unreadable, ///< the bytes cannot be read, or do not decode
    Changed,    ///< encoding gives other bytes
    Unresolved  ///< it names a record, or a part of one, that does not exist
};

/// A defect of one record.
struct Fault {
    FaultKind kind = FaultKind::Unreadable;
    FileRole role = FileRole::Portal;
    RecordId id = 0;
    std::string what;
};
[[nodiscard]] LIMEN_API const char* nameOf(FaultKind kind);

struct VerifyReport {
    struct Sum {
        std::uint64_t records = 0, bytes = 0;
    };
    std::array<Sum, static_cast<std::size_t>(RecordKind::Other) + 1> byKind{}; ///< bytes of payloads
    std::array<std::uint64_t, 3> faultCounts{};                                ///< by FaultKind
    std::vector<Fault> faults;         ///< the first `mostFaults`, in the order of files and ids
    std::vector<std::string> warnings; ///< about files as a whole

    bool isStopped = false; ///< the rest of the records was not read

    [[nodiscard]] bool isClean() const { return faultCounts[0] + faultCounts[1] + faultCounts[2] == 0; }
};

struct VerifyOptions {
    std::size_t mostFaults = 1000; ///< faults that are stored; all are counted
    /// Called after each record with the number of records and of those done.
    std::function<void(std::size_t total, std::size_t done)> progress;
    /// Called after each record; true ends the run early.
    std::function<bool()> stopped{};
};

/// Reads every record, decodes those of RecordTypes, encodes them again and compares, and looks up every
/// reference (References.h). Also looks up the shapes of cells and the portals that portals lead to.
/// References into files that are not among `files` are not checked. Requires: each role occurs once. Memory:
/// 32 bytes a record, and the portals of all shapes.
[[nodiscard]] LIMEN_API VerifyReport verify(std::span<const File* const> files,
                                            const VerifyOptions& options = {});

} // namespace limen::dat
