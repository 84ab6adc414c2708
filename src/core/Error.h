#pragma once

#include <string>
#include <tl/expected.hpp>

namespace limen {

/// Why something asked of us could not be done.
enum class ErrorCode {
    NotFound,    ///< a file, record, name or place that does not exist
    Unreadable,  ///< the operating system refused to open, read, map or write
    Malformed,   ///< bytes that contradict the format
    Unsupported, ///< well formed, but not something we can handle
    BadArgument, ///< what the user asked for makes no sense
    Driver,      ///< the graphics driver lacks something or failed
};

/// One sentence for a person: what, where in which file or record, and what was expected or what to do.
struct Error {
    ErrorCode code = ErrorCode::Malformed;
    std::string where; ///< file name, and offset or record id where they are known; may be empty
    std::string what;  ///< what is wrong, in words, without a full stop

    /// "where: what".
    [[nodiscard]] std::string message() const;
};

/// A value, or the reason there is none.
template <class T>
using Result = tl::expected<T, Error>;

/// Shorthand for returning an error from a function that yields a Result.
[[nodiscard]] tl::unexpected<Error> fail(ErrorCode code, std::string where, std::string what);

} // namespace limen
