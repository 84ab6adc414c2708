#include "engine/HeapTuning.h"

#include <cstdlib> // defines __GLIBC__ if the C library is glibc
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <vector>
#ifdef __GLIBC__
#include <malloc.h>
#include <unistd.h>

namespace limen::test {
namespace {

/// Settings are the process's, so each test has processes of its own, which begin with glibc's.
class HeapTuning : public ::testing::Test {
protected:
    HeapTuning() {
        GTEST_FLAG_SET(death_test_style, "threadsafe");
        unsetenv("GLIBC_TUNABLES");
    }
};

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

TEST_F(HeapTuning, theMemoryOfAFrameStaysWithTheProgram) {
    const auto exitAfter = [](std::size_t mebibytes) {
        engine::tuneHeapForHours();
        std::_Exit(staysLarge(mebibytes) ? 0 : 1);
    };
    EXPECT_EXIT(exitAfter(8), ::testing::ExitedWithCode(0), "");
    EXPECT_EXIT(exitAfter(64), ::testing::ExitedWithCode(1), "") << "more goes back to the system";
}

/// Bytes that are free in the heap after an array of 64 MiB was allocated and freed; 0 if it was mapped outside the heap.
std::size_t keptOfAnArray() {
    std::unique_ptr<char[]> array(new char[std::size_t{64} << 20]);
    static_cast<volatile char*>(array.get())[0] = 1;
    const bool isMapped = mallinfo2().hblkhd >= std::size_t{64} << 20;
    array.reset();
    return isMapped ? 0 : mallinfo2().fordblks;
}

/// Whether Linux was asked for large pages in a part of the heap.
bool heapHasLargePages() {
    std::ifstream maps("/proc/self/smaps");
    bool isHeap = false, found = false;
    for (std::string line;
         std::getline(maps, line);) { // a mapping's first line names it, its last has the flags
        isHeap = isHeap || line.ends_with("[heap]");
        if (!line.starts_with("VmFlags:"))
            continue;
        found = found || (isHeap && line.find(" hg") != std::string::npos);
        isHeap = false;
    }
    return found;
}

TEST_F(HeapTuning, aShortRunKeepsTheMemoryOfFreedArrays) {
    const auto exitTuned = [] {
        engine::tuneHeapForOneRun();
        std::_Exit(keptOfAnArray() >= std::size_t{64} << 20 ? 0 : 1);
    };
    EXPECT_EXIT(exitTuned(), ::testing::ExitedWithCode(0), "");
    EXPECT_EXIT(std::_Exit(keptOfAnArray() == 0 ? 0 : 1), ::testing::ExitedWithCode(0), "")
        << "without the setting it is mapped, and returned to the system";
}

TEST_F(HeapTuning, theHeapOfAShortRunHasLargePages) {
    if (!std::filesystem::exists("/sys/kernel/mm/transparent_hugepage"))
        GTEST_SKIP() << "this Linux has no large pages";
    const auto exitTuned = [] {
        engine::tuneHeapForOneRun();
        std::_Exit(heapHasLargePages() ? 0 : 1);
    };
    EXPECT_EXIT(exitTuned(), ::testing::ExitedWithCode(0), "");
    EXPECT_EXIT(std::_Exit(heapHasLargePages() ? 1 : 0), ::testing::ExitedWithCode(0), "");
}

} // namespace
} // namespace limen::test
#endif
