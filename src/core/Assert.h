#pragma once

namespace limen {

/// Reports a broken contract of ours on standard error and aborts.
[[noreturn]] void assertionFailed(const char* expression, const char* message, const char* file, int line);

} // namespace limen

/// States a contract or an invariant. A failure is a mistake of the programmer, never of a file or a user:
/// those get an Error. Stays on in every build; keep it out of per-pixel and per-vertex loops.
#define LIMEN_ASSERT(condition, message)                                                                     \
    (static_cast<bool>(condition) ? void(0)                                                                  \
                                  : ::limen::assertionFailed(#condition, message, __FILE__, __LINE__))
