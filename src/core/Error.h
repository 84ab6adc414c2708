#pragma once

#include <string>
#include <tl/expected.hpp>

namespace limen {

/// The kind of a failure.
enum class ErrorCode {
    NotFound,    ///< a file, record, name or place that does not exist
    Unreadable,  ///< the operating system refused to open, read, map or write
    Malformed,   ///< bytes that contradict the format
    Unsupported, ///< well formed, but beyond this program
    BadArgument, ///< a command line or request that makes no sense
    Driver,      ///< the graphics driver lacks something or failed
};

/// A failure as one sentence for the user: the fault, its place in a file or record, and the expected value
/// or next step.
struct Error {
    ErrorCode code = ErrorCode::Malformed;
    std::string where; ///< file name, and offset or record id where they are known; may be empty
    std::string what;  ///< the fault and the next step, without a full stop

    /// `where`, a colon and `what`.
    [[nodiscard]] std::string message() const;
};

/// A value, or the reason why there is none.
template <class T>
using Result = tl::expected<T, Error>;

/// Shorthand for returning an error from a function that yields a Result.
[[nodiscard]] tl::unexpected<Error> fail(ErrorCode code, std::string where, std::string what);

} // namespace limen
