#include "engine/HeapTuning.h"

#include <cstdlib> // defines __GLIBC__ if the C library is glibc
#ifdef __GLIBC__
#include <cstddef>
#include <limits>
#include <malloc.h>
#include <memory>
#include <sys/mman.h>
#endif

namespace limen::engine {

#ifdef __GLIBC__
namespace {

constexpr std::size_t kLargePage = std::size_t{2} << 20; // bytes

/// Asks for large pages in the heap's next `bytes`. They are allocated and freed, but not touched.
void useLargePages(std::size_t bytes) {
    void* const block = std::malloc(bytes);
    void* at = block;
    if (block != nullptr && std::align(kLargePage, kLargePage, at, bytes) != nullptr)
        (void)madvise(at, bytes / kLargePage * kLargePage, MADV_HUGEPAGE); // fails where there are none
    std::free(block);
}

} // namespace
#endif

void tuneHeapForHours() {
#ifdef __GLIBC__
    constexpr int kLarge = 1 << 20; // bytes
    (void)mallopt(M_ARENA_MAX, 1);
    (void)mallopt(M_MMAP_THRESHOLD, kLarge);
    (void)mallopt(M_TRIM_THRESHOLD, 32 * kLarge);
#endif
}

void tuneHeapForOneRun() {
#ifdef __GLIBC__
    constexpr int kAll = std::numeric_limits<int>::max();
    (void)mallopt(M_ARENA_MAX, 1);
    (void)mallopt(M_MMAP_THRESHOLD, kAll);
    (void)mallopt(M_TRIM_THRESHOLD, kAll);
    useLargePages(std::size_t{1} << 30);
#endif
}

void giveBackFreeMemory() {
#ifdef __GLIBC__
    (void)::malloc_trim(0);
#endif
}

} // namespace limen::engine
