#pragma once

namespace limen::engine {

/// Tunes glibc's allocator for programs that load parts of the world for hours. Call it at the start; with
/// other C libraries it does nothing.
/// - All threads use one arena. The thread that reads the next part then reuses the memory that the last
///   reader freed. The cost: threads that allocate much at the same time wait for each other.
/// - Arrays of 1 MiB and more are mapped from the system and returned to it. Otherwise the allocator learns
///   to keep them in the heap and places small, long-lived blocks between them, so that the heap fragments
///   and grows.
/// - Up to 32 MiB that are free at the heap's end stay with the program. A software driver allocates and frees some MiB
///   for each frame, in blocks of 64 KiB, and each would otherwise be a call of the system and page faults.
void tuneHeapForHours();

/// Tunes glibc's allocator for programs that load a world, draw or trace, and end. Call it at the start; with other C
/// libraries it does nothing (docs/decisions/0226-short-runs-keep-their-heap.md).
/// - All threads use one arena, and arrays of all sizes are in the heap. Free memory stays with the program.
/// - The first GiB of the heap has pages of 2 MiB, where Linux has them. It takes address space alone until it is used.
void tuneHeapForOneRun();

/// Returns free memory within the heap to the system, of all threads, with glibc. Other threads that allocate wait some
/// milliseconds. For a program's own process: in a library it would delay the host.
void giveBackFreeMemory();

} // namespace limen::engine
