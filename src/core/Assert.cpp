#include "core/Assert.h"

#include <cstdio>
#include <cstdlib>

namespace limen {

void assertionFailed(const char* expression, const char* message, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: assertion failed: %s (%s)\n", file, line, message, expression);
    (void)std::fflush(stderr); // buffered on Windows, and abort() does not write it
    std::abort();
}

} // namespace limen
