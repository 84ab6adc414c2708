#pragma once

namespace limen::engine {

/// For programs that load one part of the world after the other for hours; to be called before they begin. Where the allocator is glibc's,
/// all threads allocate from one arena from here on: what the thread that read one part gives back, the one that reads the next finds
/// again, though threads that allocate much at once wait for each other. And arrays of a MiB and more are the system's own from
/// beginning to end: else the allocator learns to keep them, and lays what is small and lives long in between.
void tuneHeap();

} // namespace limen::engine
