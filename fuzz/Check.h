#pragma once

#include "core/Error.h"

#include <cstdio>
#include <cstdlib>

/// Aborts if `condition` is false; libFuzzer then stores the input.
#define FUZZ_CHECK(condition)                                                                                \
    do {                                                                                                     \
        if (!(condition)) {                                                                                  \
            std::fprintf(stderr, "%s:%d: does not hold: %s\n", __FILE__, __LINE__, #condition);              \
            std::abort();                                                                                    \
        }                                                                                                    \
    } while (false)

namespace limen::fuzz {

/// Aborts if a text was refused without a reason.
template <class T>
void expectReason(const Result<T>& read) {
    FUZZ_CHECK(read.has_value() || !read.error().what.empty());
}

} // namespace limen::fuzz
