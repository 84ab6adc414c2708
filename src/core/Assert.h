#pragma once

namespace limen {

/// Prints a broken contract to standard error and aborts.
[[noreturn]] void assertionFailed(const char* expression, const char* message, const char* file, int line);

} // namespace limen

/// Checks a contract or an invariant. A failure is a mistake of the programmer; mistakes of a file or a user
/// become an Error. Stays on in every build; keep it out of per-pixel and per-vertex loops.
#define LIMEN_ASSERT(condition, message)                                                                     \
    (static_cast<bool>(condition) ? void(0)                                                                  \
                                  : ::limen::assertionFailed(#condition, message, __FILE__, __LINE__))
