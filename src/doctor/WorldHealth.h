#pragma once

#include "doctor/FileHealth.h"

#include <span>

// Whether the records of a world are there and decode.
namespace limen::doctor {

/// Called with the number of steps and of those done.
using HealthProgress = std::function<void(std::size_t total, std::size_t done)>;

struct WorldOptions {
    bool thorough = false; ///< decode every record and follow all references; else a sample of each kind
    HealthProgress progress;
};

/// Counts of record kinds, the records that a world cannot do without, and a sample of records (or all). Requires: the
/// files are sound and have the expected roles; each role at most once. Checks that need a missing file are NotTested.
[[nodiscard]] Findings judgeWorld(std::span<const FileHealth> files, const WorldOptions& options);

/// Records of each kind that are decoded without --thorough.
inline constexpr std::size_t kSampleOfKind = 50;

} // namespace limen::doctor
