#pragma once

#include "dat/Codec.h"

namespace limen::dat {

/// Consecutive patch iterations.
struct IterationRun {
    std::int32_t first = 0, count = 0;
    friend bool operator==(const IterationRun&, const IterationRun&) = default;
};

/// The iteration record (docs/formats/container.md#iteration-record).
struct Iterations {
    std::int32_t current = 0; ///< the number of patch iterations
    std::vector<IterationRun> runs;
    friend bool operator==(const Iterations&, const Iterations&) = default;
};

/// Errors: a record that is no whole number of words, is empty, or ends within a run.
[[nodiscard]] LIMEN_API Result<Iterations> decodeIterations(ByteView payload);
/// A run of one becomes a negative word, too, as in new files. Decoding yields the same iterations. Errors: BadArgument
/// for a run whose count is not positive.
[[nodiscard]] LIMEN_API Result<Bytes> encodeIterations(const Iterations& iterations);

} // namespace limen::dat
