#include "engine/HeapTuning.h"

#include <cstdlib> // defines __GLIBC__ if the C library is glibc
#include <gtest/gtest.h>
#include <memory>
#include <vector>
#ifdef __GLIBC__
#include <unistd.h>

namespace limen::test {
namespace {

/// Allocates and frees `mebibytes` in blocks of 64 KiB, as a software driver does for a frame. Returns whether the heap has
/// the same end after that as before the blocks were freed.
bool staysLarge(std::size_t mebibytes) {
    constexpr std::size_t kBlock = 64 * 1024;
    std::vector<std::unique_ptr<char[]>> blocks(16 * mebibytes);
    for (auto& block : blocks)
        block.reset(new char[kBlock]); // not cleared: only its place counts
    const void* const end = sbrk(0);
    while (!blocks.empty())
        blocks.pop_back();
    return sbrk(0) == end;
}

TEST(HeapTuning, theMemoryOfAFrameStaysWithTheProgram) {
    GTEST_FLAG_SET(death_test_style, "threadsafe"); // in a process of its own: the setting is the process's
    const auto exitAfter = [](std::size_t mebibytes) {
        engine::tuneHeap();
        std::_Exit(staysLarge(mebibytes) ? 0 : 1);
    };
    EXPECT_EXIT(exitAfter(8), ::testing::ExitedWithCode(0), "");
    EXPECT_EXIT(exitAfter(64), ::testing::ExitedWithCode(1), "") << "more goes back to the system";
}

} // namespace
} // namespace limen::test
#endif
