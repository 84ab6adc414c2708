#include "engine/HeapTuning.h"

#include <cstdlib> // defines __GLIBC__ if the C library is glibc
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace limen::engine {

void tuneHeap() {
#ifdef __GLIBC__
    constexpr int kLarge = 1 << 20; // bytes
    (void)mallopt(M_ARENA_MAX, 1);
    (void)mallopt(M_MMAP_THRESHOLD, kLarge);
    (void)mallopt(M_TRIM_THRESHOLD, 32 * kLarge);
#endif
}

void giveBackFreeMemory() {
#ifdef __GLIBC__
    (void)::malloc_trim(0);
#endif
}

} // namespace limen::engine
