#pragma once

#include <cstddef>

namespace limen {

/// Prefetches an object into the cache: its memory latency overlaps with the work before its first use. Has
/// no effect but on time.
template <class T>
void prefetch(const T& object) {
    constexpr std::size_t kLine = 64; // bytes of a cache line
    const auto* const bytes = reinterpret_cast<const std::byte*>(&object);
    for (std::size_t at = 0; at < sizeof(T); at += kLine)
        __builtin_prefetch(bytes + at);
    __builtin_prefetch(bytes + sizeof(T) - 1);
}

} // namespace limen
