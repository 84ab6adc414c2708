#include "dat/File.h"
#include "dat/Writer.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace limen::dat {
namespace {

Bytes patternOf(RecordId id, std::size_t size) {
    Bytes out(size);
    for (std::size_t i = 0; i < size; ++i)
        out[i] = static_cast<std::byte>((id * 31 + i * 7) & 0xFF);
    return out;
}

/// The size of a record, by its id: empty, one block, one block and a byte, several blocks.
std::size_t sizeOf(RecordId id, std::size_t capacity) {
    const std::size_t sizes[] = {
        0, 1, 12, capacity - 1, capacity, capacity + 1, 2 * capacity, 3 * capacity + 5};
    return id % 50 == 0 ? sizes[(id / 50) % 8] : 8;
}

struct Shape {
    std::uint32_t blockSize;
    RecordId count;
};

class ContainerRoundTrip : public testing::TestWithParam<Shape> {};

TEST_P(ContainerRoundTrip, findsReadsAndWalksEveryRecord) {
    const auto [blockSize, count] = GetParam();
    FileTraits traits = FileTraits::portal();
    traits.blockSize = blockSize;
    Writer writer(traits);
    const auto idOf = [](RecordId i) { return 0x01000000u + i * 0x2003u; };
    for (RecordId i = 0; i < count; ++i)
        writer.add(idOf(i), patternOf(i, sizeOf(i, blockSize - 4)));
    const Bytes bytes = *writer.build();
    EXPECT_EQ(bytes.size() % blockSize, 0u);
    const auto file = File::fromBytes(bytes, "made.dat");
    ASSERT_TRUE(file) << file.error().message();
    EXPECT_TRUE(file->warnings().empty());
    Bytes scratch;
    for (RecordId i = 0; i < count; ++i) {
        const auto payload = file->read(idOf(i), scratch);
        ASSERT_TRUE(payload) << payload.error().message();
        const Bytes expected = patternOf(i, sizeOf(i, blockSize - 4));
        ASSERT_TRUE(std::equal(payload->begin(), payload->end(), expected.begin(), expected.end())) << i;
        const auto missing = file->find(idOf(i) + 1);
        ASSERT_TRUE(missing && !*missing);
    }
    RecordId next = 0;
    std::vector<std::string> warnings;
    const auto walked = file->forEach(
        [&, records = count](const Entry& entry) { // clang 14 cannot capture a structured binding
            EXPECT_EQ(entry.id, next < records ? idOf(next) : kIterationId);
            ++next;
            return true;
        },
        &warnings);
    ASSERT_TRUE(walked) << walked.error().message();
    EXPECT_EQ(next, count + 1);
    EXPECT_TRUE(warnings.empty());
}

INSTANTIATE_TEST_SUITE_P(BothBlockSizes, ContainerRoundTrip,
                         testing::Values(Shape{1024, 0}, Shape{1024, 1}, Shape{1024, 60}, Shape{1024, 61},
                                         Shape{1024, 62}, Shape{1024, 3843}, Shape{1024, 3844},
                                         Shape{1024, 20000}, Shape{256, 1}, Shape{256, 60}, Shape{256, 61},
                                         Shape{256, 500}, Shape{256, 4000}, Shape{256, 20000}, Shape{64, 200},
                                         Shape{65536, 100}));

/// Bytes of mapped files in this process's memory.
std::size_t mappedBytes() {
    std::ifstream status("/proc/self/status");
    std::string word;
    std::size_t kilobytes = 0;
    while (status >> word && word != "RssFile:") {
    }
    status >> kilobytes;
    return kilobytes << 10;
}

TEST(DatFile, pagesThatItLetsGoCountNoLongerAndAreReadAgain) {
    constexpr RecordId kRecords = 16000;
    constexpr std::size_t kSize = 1000, kMost = std::size_t{1} << 20;
    Writer writer(FileTraits::portal());
    for (RecordId i = 0; i < kRecords; ++i)
        writer.add(0x01000000u + i, patternOf(i, kSize));
    const std::string path = testing::TempDir() + "lets-go.dat";
    ASSERT_TRUE(writer.write(path));
    const std::size_t before = mappedBytes();
    Result<File> file = File::open(path);
    ASSERT_TRUE(file) << file.error().message();
    Bytes scratch;
    const auto areRead = [&] {
        for (RecordId i = 0; i < kRecords; ++i) {
            const auto payload = file->read(0x01000000u + i, scratch);
            if (!payload || !std::equal(payload->begin(), payload->end(), patternOf(i, kSize).begin()))
                return false;
        }
        return true;
    };
    EXPECT_TRUE(areRead());
    EXPECT_GT(mappedBytes(), before + 12 * kMost);
    file->letPagesGo();
    EXPECT_LT(mappedBytes(), before + kMost);
    EXPECT_TRUE(areRead());
    EXPECT_GT(mappedBytes(), before + 12 * kMost);
    file->letPagesGoEvery(kMost);
    EXPECT_TRUE(areRead()) << "letting go changes no byte";
    EXPECT_LT(mappedBytes(), before + 5 * kMost) << "Linux maps up to 2 MiB around a page";
    std::filesystem::remove(path);
}

} // namespace
} // namespace limen::dat
