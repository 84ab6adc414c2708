#pragma once

namespace limen::app {

/// From here on all threads allocate from one arena, where the allocator has several (glibc): what the thread that read one part of the
/// world gives back, the one that reads the next finds again. Threads that allocate much at once wait for each other.
void shareOneArena();

} // namespace limen::app
