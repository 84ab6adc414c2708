#include "dat/File.h"
#include "dat/Hex.h"
#include "dat/RandomRecords.h"
#include "dat/RecordTypes.h"
#include "dat/Writer.h"

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <new>
#include <random>

#include <gtest/gtest.h>

// Counts heap allocations. Replacing operator new needs one pair of definitions in a program, hence a
// separate test program.
namespace {
std::atomic<std::size_t> liveBytes{0};
std::atomic<std::size_t> peakBytes{0};
constexpr std::size_t kTag = alignof(std::max_align_t);
} // namespace

void* operator new(std::size_t size) {
    auto* block = static_cast<unsigned char*>(std::malloc(size + kTag));
    if (block == nullptr)
        std::abort();
    *reinterpret_cast<std::size_t*>(block) = size;
    const std::size_t live = liveBytes += size;
    std::size_t peak = peakBytes;
    while (peak < live && !peakBytes.compare_exchange_weak(peak, live)) {
    }
    return block + kTag;
}
void operator delete(void* pointer) noexcept {
    if (pointer == nullptr)
        return;
    auto* block = static_cast<unsigned char*>(pointer) - kTag;
    liveBytes -= *reinterpret_cast<std::size_t*>(block);
    std::free(block);
}
void operator delete(void* pointer, std::size_t) noexcept {
    ::operator delete(pointer);
}

namespace limen::dat {
namespace {

/// The peak of heap bytes in use during `work`, minus those in use before.
template <class Work>
std::size_t peakOf(Work&& work) {
    const std::size_t before = liveBytes;
    peakBytes = before;
    work();
    return peakBytes - before;
}

constexpr std::size_t kSlack = 4096; // messages, and lists of a few elements
constexpr std::size_t kMultiple = 16;

template <class Record>
class MemoryBound : public testing::Test {};
TYPED_TEST_SUITE(MemoryBound, RecordTypes::As<testing::Types>);

// Replaces every word of a record by a count far above the bytes of the file, and by one slightly above them.
TYPED_TEST(MemoryBound, malformedCountsNeverAllocateMuchMoreThanTheInput) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const auto record = RandomRecords(seed).make<TypeParam>();
        const Bytes good = *encode(record);
        RecordId id = 0;
        if constexpr (requires { record.id; })
            id = record.id;
        for (std::size_t at = 0; at + 4 <= good.size(); at += 1 + good.size() / 400) {
            for (const std::uint32_t value :
                 {0xFFFFFFFFu, 0x7FFFFFFFu, 0x10000000u, static_cast<std::uint32_t>(good.size() / 8)}) {
                Bytes bytes = good;
                std::memcpy(bytes.data() + at, &value, sizeof value);
                const std::size_t peak = peakOf([&] { (void)decode<TypeParam>(id, bytes); });
                ASSERT_LE(peak, kMultiple * bytes.size() + kSlack) << "seed " << seed << ", offset " << at;
            }
        }
    }
}

TEST(MemoryBoundTree, theSmallestNodesCostTheMost) {
    // A cell tree of inner nodes with two leaves each: 36 bytes for three nodes.
    std::string text =
        "01 00 00 0D  01 00 00 00  00 00 00 00  00 00 00 00 00 00 00 00 00 00 00 00  01 00 00 00 00 00 00 00";
    for (int i = 0; i < 400; ++i)
        text += "4E 49 50 42  00 00 80 3F 00 00 00 00 00 00 00 00 00 00 00 00  46 41 45 4C 00 00 00 00 ";
    const Bytes bytes = hex(text);
    const std::size_t peak = peakOf([&] { EXPECT_FALSE(decode<Environment>(0x0D000001, bytes)); });
    EXPECT_LE(peak, 24 * bytes.size() + kSlack);
}

TEST(MemoryBoundFile, damagedFilesNeverAllocateMuchMoreThanTheyAreLong) {
    Writer writer(FileTraits::cell());
    for (RecordId id = 1; id < 200; ++id)
        writer.add(id, Bytes(id * 5), id % 10 == 0);
    const Bytes good = *writer.build();
    std::mt19937 random(5);
    for (int round = 0; round < 400; ++round) {
        Bytes bytes = good;
        for (int i = 0; i < 8; ++i) {
            const std::uint32_t value =
                round % 2 == 0 ? 0x7FFFFFF0u : static_cast<std::uint32_t>(random() % bytes.size());
            const std::size_t tree = bytes.size() - 8 * 256 * 7;
            std::memcpy(bytes.data() + tree + random() % (bytes.size() - tree - 4) / 4 * 4, &value,
                        sizeof value);
        }
        const std::size_t peak = peakOf([&] {
            const auto file = File::fromBytes(bytes, "bad.dat");
            if (!file)
                return;
            Bytes scratch;
            (void)file->forEach([&](const Entry& entry) {
                (void)file->read(entry, scratch);
                return true;
            });
        });
        ASSERT_LE(peak, 4 * bytes.size() + kSlack);
    }
}

} // namespace
} // namespace limen::dat
