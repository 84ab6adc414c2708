#include "dat/File.h"
#include "dat/Hex.h"
#include "dat/Writer.h"

#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// Every row of formats/container.md §9: a reader refuses such files, with file and place in the message.
namespace limen::dat {
namespace {

using testing::HasSubstr;

std::uint32_t wordAt(const Bytes& bytes, std::size_t offset) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + offset, sizeof word);
    return word;
}
void putWord(Bytes& bytes, std::size_t offset, std::uint32_t word) {
    std::memcpy(bytes.data() + offset, &word, sizeof word);
}

constexpr std::size_t kBlockSizeAt = 0x144, kFileSizeAt = 0x148, kTypeAt = 0x14C, kRootAt = 0x160;
constexpr std::size_t kNodeCountAt = 4 + 248; ///< in the first block of a portal node, behind the link
constexpr std::size_t kNodeEntriesAt = 4 + 252;

/// The offset of byte `logical` of a node in consecutive blocks.
std::size_t inNode(std::size_t node, std::size_t logical) {
    return node + logical / 1020 * 1024 + 4 + logical % 1020;
}

/// A portal file with `records` records of `size` bytes, ids 1, 2, 3 ...
Bytes portalFile(RecordId records, std::size_t size) {
    Writer writer(FileTraits::portal());
    for (RecordId id = 1; id <= records; ++id)
        writer.add(id, Bytes(size, static_cast<std::byte>(id)));
    return writer.build();
}

Error openError(const Bytes& bytes) {
    const auto file = File::fromBytes(bytes, "bad.dat");
    EXPECT_FALSE(file);
    return file ? Error{} : file.error();
}

Error readError(const Bytes& bytes, RecordId id) {
    const auto file = File::fromBytes(bytes, "bad.dat");
    EXPECT_TRUE(file) << file.error().message();
    Bytes scratch;
    const auto payload = file ? file->read(id, scratch) : tl::unexpected(Error{});
    EXPECT_FALSE(payload);
    return payload ? Error{} : payload.error();
}

Error walkError(const Bytes& bytes) {
    const auto file = File::fromBytes(bytes, "bad.dat");
    EXPECT_TRUE(file) << file.error().message();
    if (!file)
        return {};
    const auto walked = file->forEach([](const Entry&) { return true; });
    EXPECT_FALSE(walked);
    return walked ? Error{} : walked.error();
}

/// Offset of the entry of `id` in a file whose only node is its root.
std::size_t entryAt(const Bytes& bytes, RecordId id) {
    return wordAt(bytes, kRootAt) + kNodeEntriesAt + (id - 1) * 24;
}

// The smallest file, from the format page: header, iteration record, one leaf.
TEST(ContainerRules, readsTheSmallestFileTypedByHand) {
    Bytes bytes(0x1000);
    const auto place = [&](std::size_t at, std::string_view text) {
        const Bytes part = hex(text);
        std::copy(part.begin(), part.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
    };
    place(0x100, "00 50 4C 00");
    place(0x140, "42 54 00 00  00 04 00 00  00 10 00 00  01 00 00 00  00 00 00 00");
    place(0x160, "00 08 00 00");
    place(0x174, "6E 00 00 00");
    place(0x18C, "01 1A 00 00");
    place(0x400, "00 00 00 00  05 00 00 00  FB FF FF FF  01 00 00 00");
    place(0x800, "00 0C 00 00");
    place(0x8FC, "01 00 00 00  00 00 02 00  01 00 FF FF  00 04 00 00  0C 00 00 00  00 00 00 00  05 00 00 00");
    const auto file = File::fromBytes(bytes, "hand.dat");
    ASSERT_TRUE(file) << file.error().message();
    EXPECT_TRUE(file->warnings().empty());
    EXPECT_EQ(file->role(), FileRole::Portal);
    EXPECT_EQ(file->header().engineVersion, 110u);
    EXPECT_EQ(file->header().minorVersion, 6657u);
    const auto entry = file->find(kIterationId);
    ASSERT_TRUE(entry && *entry);
    EXPECT_EQ((*entry)->version, 2);
    EXPECT_EQ((*entry)->iteration, 5);
    Bytes scratch;
    const auto payload = file->read(kIterationId, scratch);
    ASSERT_TRUE(payload);
    EXPECT_EQ(toHex(*payload), "05 00 00 00 FB FF FF FF 01 00 00 00 ");
}

// The writer makes the same file except for the number of the iteration.
TEST(ContainerRules, theWritersSmallestFileHasThatLayout) {
    const Bytes bytes = Writer(FileTraits::portal()).build();
    EXPECT_EQ(bytes.size(), 0x1000u);
    EXPECT_EQ(wordAt(bytes, 0x140), 0x5442u);
    EXPECT_EQ(wordAt(bytes, kRootAt), 0x800u);
    EXPECT_EQ(wordAt(bytes, 0x404), 1u);
    EXPECT_EQ(wordAt(bytes, 0x800), 0xC00u);
    EXPECT_EQ(wordAt(bytes, 0x8FC), 1u);
    EXPECT_EQ(wordAt(bytes, 0x904), kIterationId);
}

TEST(ContainerRules, foreignFilesAreNamedForWhatTheyAre) {
    EXPECT_EQ(openError({}).message(), "bad.dat: the file is empty, not a dat file");
    EXPECT_THAT(openError(Bytes(4096)).what, HasSubstr("nothing but zeros"));
    const std::string prose = "You can't go home again, but you can read your mail there.\n";
    std::string text;
    for (int i = 0; i < 20; ++i)
        text += prose;
    const auto* first = reinterpret_cast<const std::byte*>(text.data());
    EXPECT_THAT(openError(Bytes(first, first + text.size())).what, HasSubstr("text file"));
    EXPECT_THAT(openError(Bytes(first, first + 20)).what, HasSubstr("text file"));
    EXPECT_THAT(openError(Bytes(100, std::byte{1})).what, HasSubstr("100 bytes"));
    Bytes noise(4096, std::byte{0x81});
    noise[0] = std::byte{1};
    EXPECT_THAT(openError(noise).what, HasSubstr("magic"));
}

TEST(ContainerRules, filesFromBeforeTheEndOfRetailAreUnsupported) {
    Bytes bytes = portalFile(3, 10);
    const Bytes fields(bytes.begin() + 0x140, bytes.begin() + 0x16C);
    std::fill(bytes.begin() + 0x140, bytes.begin() + 0x190, std::byte{0});
    std::copy(fields.begin(), fields.end(), bytes.begin() + 0x12C);
    const Error error = openError(bytes);
    EXPECT_EQ(error.code, ErrorCode::Unsupported);
    EXPECT_THAT(error.what, HasSubstr("older than the end of retail"));
}

TEST(ContainerRules, sillyBlockSizesAreRefused) {
    for (const std::uint32_t size : {0u, 1u, 32u, 1000u, 1023u, 131072u, 0x80000000u, 0xFFFFFFFFu}) {
        Bytes bytes = portalFile(3, 10);
        putWord(bytes, kBlockSizeAt, size);
        EXPECT_THAT(openError(bytes).what, HasSubstr("block size")) << size;
    }
    Bytes bytes = portalFile(3, 10);
    putWord(bytes, kBlockSizeAt, 65536);
    EXPECT_THAT(openError(bytes).what, HasSubstr("before the end of its first block"));
}

TEST(ContainerRules, unknownTypesAreRefused) {
    Bytes bytes = portalFile(3, 10);
    putWord(bytes, kTypeAt, 4);
    EXPECT_THAT(openError(bytes).what, HasSubstr("file type is 4"));
}

TEST(ContainerRules, anotherLengthThanTheHeadersIsAWarning) {
    Bytes bytes = portalFile(3, 10);
    putWord(bytes, kFileSizeAt, 0x12345);
    const auto file = File::fromBytes(bytes, "odd.dat");
    ASSERT_TRUE(file);
    ASSERT_EQ(file->warnings().size(), 1u);
    EXPECT_THAT(file->warnings()[0], HasSubstr("header says 74565 bytes"));
}

TEST(ContainerRules, truncatedFilesAreCalledSo) {
    const Bytes whole = portalFile(30, 5000);
    for (std::size_t length = 0; length < whole.size(); length += 512) {
        const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
        const Error error = openError(cut); // the root comes last, so it is always missing
        EXPECT_THAT(error.where, HasSubstr("bad.dat"));
        if (length >= 0x800)
            EXPECT_THAT(error.what, HasSubstr("(the file is cut short: " + std::to_string(length) + " of "));
    }
}

TEST(ContainerRules, recordsBeyondTheEndOfATruncatedFileAreRefused) {
    // The last record's blocks are moved behind everything else and cut off in the middle.
    Bytes bytes = portalFile(3, 5000);
    const std::size_t entry = entryAt(bytes, 3);
    const auto end = static_cast<std::uint32_t>(bytes.size());
    bytes.resize(end + 2 * 1024);
    putWord(bytes, entry + 8, end);
    putWord(bytes, end, end + 1024);
    putWord(bytes, end + 1024, end + 2048);
    putWord(bytes, kFileSizeAt, end + 5 * 1024);
    const Error error = readError(bytes, 3);
    EXPECT_THAT(error.what, HasSubstr("not the offset of a block"));
    EXPECT_THAT(error.what, HasSubstr("cut short"));
    const auto file = File::fromBytes(bytes, "bad.dat");
    Bytes scratch;
    EXPECT_TRUE(file->read(1, scratch)) << "existing records stay readable";
}

TEST(ContainerRules, rootsOutOfRangeAreRefused) {
    const Bytes good = portalFile(3, 10);
    for (const std::uint32_t root :
         {4u, 0x401u, static_cast<std::uint32_t>(good.size()), 0x80000400u, 0xFFFFFC00u}) {
        Bytes bytes = good;
        putWord(bytes, kRootAt, root);
        EXPECT_THAT(openError(bytes).what, HasSubstr("not the offset of a block")) << root;
    }
}

TEST(ContainerRules, anEmptyTreeHoldsNothing) {
    Bytes bytes = portalFile(3, 10);
    putWord(bytes, kRootAt, 0);
    const auto file = File::fromBytes(bytes, "empty.dat");
    ASSERT_TRUE(file);
    EXPECT_FALSE((*file->find(1)).has_value());
    Bytes scratch;
    const auto payload = file->read(1, scratch);
    ASSERT_FALSE(payload);
    EXPECT_EQ(payload.error().code, ErrorCode::NotFound);
    EXPECT_EQ(payload.error().message(), "empty.dat: there is no record 0x00000001");
}

TEST(ContainerRules, recordOffsetsOutOfRangeAreRefused) {
    const Bytes good = portalFile(3, 10);
    for (const std::uint32_t offset : {0u, 0x200u, 0x401u, 0x7FFFFC00u, 0x80000400u, 0xFFFFFC00u}) {
        Bytes bytes = good;
        putWord(bytes, entryAt(good, 2) + 8, offset);
        const Error error = readError(bytes, 2);
        EXPECT_THAT(error.message(), HasSubstr("bad.dat, record 0x00000002: "));
        EXPECT_THAT(error.what, HasSubstr("not the offset of a block"));
    }
}

TEST(ContainerRules, truncatedChainsAreRefused) {
    Bytes bytes = portalFile(3, 5000); // five blocks a record
    const std::uint32_t first = wordAt(bytes, entryAt(bytes, 2) + 8);
    putWord(bytes, first + 1024, 0);
    EXPECT_THAT(readError(bytes, 2).what, HasSubstr("ends too early"));
    putWord(bytes, first + 1024, 0x80000400);
    EXPECT_THAT(readError(bytes, 2).what, HasSubstr("0x80000400 is not the offset of a block"));
}

TEST(ContainerRules, chainsThatComeBackAreRefused) {
    Bytes bytes = portalFile(3, 5000);
    const std::uint32_t first = wordAt(bytes, entryAt(bytes, 2) + 8);
    putWord(bytes, first + 2 * 1024, first + 1024);
    EXPECT_THAT(readError(bytes, 2).what, HasSubstr("comes back to"));
    putWord(bytes, first, first);
    EXPECT_THAT(readError(bytes, 2).what, HasSubstr("comes back to"));
}

TEST(ContainerRules, chainsInAnyOrderAndWithALongerTailAreRead) {
    Bytes bytes = portalFile(3, 2000); // two blocks a record
    const std::uint32_t a = wordAt(bytes, entryAt(bytes, 2) + 8);
    const std::uint32_t b = a + 1024;
    std::swap_ranges(bytes.begin() + a, bytes.begin() + a + 1024, bytes.begin() + b);
    putWord(bytes, b, a); // now it starts at b
    putWord(bytes, a, a); // bytes behind the last block are ignored
    putWord(bytes, entryAt(bytes, 2) + 8, b);
    const auto file = File::fromBytes(bytes, "swapped.dat");
    ASSERT_TRUE(file);
    Bytes scratch;
    const auto payload = file->read(2, scratch);
    ASSERT_TRUE(payload) << payload.error().message();
    EXPECT_TRUE(std::all_of(payload->begin(), payload->end(), [](std::byte x) { return x == std::byte{2}; }));
}

TEST(ContainerRules, sizesBeyondTheFileAreRefused) {
    for (const std::uint32_t size : {0x00010000u, 0x7FFFFFFFu, 0xFFFFFFFFu}) {
        Bytes bytes = portalFile(3, 10);
        putWord(bytes, entryAt(bytes, 2) + 12, size);
        EXPECT_THAT(readError(bytes, 2).what, HasSubstr("larger than the file")) << size;
    }
}

TEST(ContainerRules, tooManyEntriesAreRefused) {
    for (const std::uint32_t count : {62u, 0xFFFFFFFFu}) {
        Bytes bytes = portalFile(3, 10);
        putWord(bytes, wordAt(bytes, kRootAt) + kNodeCountAt, count);
        const Error error = openError(bytes);
        EXPECT_THAT(error.what, HasSubstr("entries; 61 fit"));
        EXPECT_THAT(error.where, HasSubstr("index node at 0x"));
    }
}

TEST(ContainerRules, aLeafMayBeFilledWithCD) {
    Bytes bytes = portalFile(3, 10);
    const std::size_t root = wordAt(bytes, kRootAt);
    for (std::size_t i = 0; i < 62; ++i)
        putWord(bytes, root + 4 + i * 4, 0xCDCDCDCD);
    const auto file = File::fromBytes(bytes, "cd.dat");
    ASSERT_TRUE(file) << file.error().message();
    EXPECT_TRUE((*file->find(2)).has_value());
    EXPECT_FALSE((*file->find(9)).has_value());
}

TEST(ContainerRules, innerNodesNeedAllTheirBranches) {
    const Bytes good = portalFile(200, 10);
    const std::size_t root = wordAt(good, kRootAt);
    const std::uint32_t count = wordAt(good, root + kNodeCountAt);
    ASSERT_GE(count, 2u);
    for (const std::uint32_t branch : {0u, 0xCDCDCDCDu, 0x12345u, 0x80000400u}) {
        Bytes bytes = good;
        putWord(bytes, root + 4 + count * 4, branch);
        EXPECT_THAT(openError(bytes).what, HasSubstr("branch ")) << branch;
    }
    Bytes bytes = good; // any bytes may follow
    putWord(bytes, root + 4 + (count + 1) * 4, 0x12345);
    EXPECT_TRUE(File::fromBytes(bytes, "good.dat"));
}

TEST(ContainerRules, nodesMayBeScatteredOverTheFile) {
    Bytes bytes = portalFile(200, 10);
    // Moves the second block of every node to the end of the file.
    const std::size_t root = wordAt(bytes, kRootAt);
    std::vector<std::size_t> nodes{root};
    for (std::size_t i = 0; i <= wordAt(bytes, root + kNodeCountAt); ++i)
        nodes.push_back(wordAt(bytes, root + 4 + i * 4));
    for (const std::size_t node : nodes) {
        const auto moved = static_cast<std::uint32_t>(bytes.size());
        bytes.resize(bytes.size() + 1024);
        std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(node + 1024), 1024, bytes.begin() + moved);
        std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(node + 1024), 1024, std::byte{0xEE});
        putWord(bytes, node, moved);
    }
    const auto file = File::fromBytes(bytes, "scattered.dat");
    ASSERT_TRUE(file) << file.error().message();
    for (int round = 0; round < 2; ++round) {
        for (RecordId id = 1; id <= 200; ++id) {
            const auto found = file->find(id);
            ASSERT_TRUE(found && *found) << id;
            EXPECT_EQ((*found)->id, id);
        }
    }
}

TEST(ContainerRules, anInnerNodeWithoutEntriesIsRefused) {
    Bytes bytes = portalFile(200, 10);
    putWord(bytes, wordAt(bytes, kRootAt) + kNodeCountAt, 0);
    EXPECT_THAT(openError(bytes).what, HasSubstr("no entries"));
}

TEST(ContainerRules, nodesThatAreTheirOwnDescendantsAreRefused) {
    Bytes bytes = portalFile(200, 10);
    const std::uint32_t root = wordAt(bytes, kRootAt);
    putWord(bytes, root + 4, root);
    EXPECT_THAT(walkError(bytes).what, HasSubstr("out of the order of the tree"));
    const auto file = File::fromBytes(bytes, "bad.dat");
    ASSERT_TRUE(file);
    EXPECT_FALSE(file->find(1).has_value());
}

TEST(ContainerRules, childrenWithTwoParentsAreRefused) {
    Bytes bytes = portalFile(200, 10);
    const std::size_t root = wordAt(bytes, kRootAt);
    putWord(bytes, root + 4 + 4, wordAt(bytes, root + 4));
    EXPECT_THAT(walkError(bytes).what, HasSubstr("out of the order of the tree"));
    // The shared leaf is emptied, so that the order is valid; the second visit is the error.
    putWord(bytes, wordAt(bytes, root + 4) + kNodeCountAt, 0);
    EXPECT_EQ(walkError(bytes).what, "two branches lead to it");
}

TEST(ContainerRules, keysOutOfOrderAreRefused) {
    Bytes swapped = portalFile(3, 10);
    putWord(swapped, entryAt(swapped, 2) + 4, 7);
    EXPECT_THAT(openError(swapped).what, HasSubstr("id 0x00000003 comes after 0x00000007"));
    Bytes twice = portalFile(3, 10);
    putWord(twice, entryAt(twice, 2) + 4, 1);
    EXPECT_THAT(openError(twice).what, HasSubstr("id 0x00000001 comes after 0x00000001"));
}

TEST(ContainerRules, keysOutsideTheParentsRangeAreRefused) {
    Bytes bytes = portalFile(200, 10);
    const std::size_t root = wordAt(bytes, kRootAt);
    const std::size_t leaf = wordAt(bytes, root + 4);
    const std::uint32_t count = wordAt(bytes, leaf + kNodeCountAt);
    // The last id of the first leaf becomes that of the separator: a duplicate across nodes.
    const std::uint32_t separator = wordAt(bytes, root + kNodeEntriesAt + 4);
    putWord(bytes, inNode(leaf, 252 + (count - 1) * 24 + 4), separator);
    EXPECT_THAT(walkError(bytes).what, HasSubstr("out of the order of the tree"));
    const auto file = File::fromBytes(bytes, "bad.dat");
    ASSERT_TRUE(file);
    EXPECT_FALSE(file->find(1).has_value());
    EXPECT_TRUE(file->find(150).has_value()) << "other branches stay readable";
}

TEST(ContainerRules, leavesAtUnequalDepthsAreAWarning) {
    Bytes bytes = portalFile(200, 10);
    const std::uint32_t root = wordAt(bytes, kRootAt);
    const std::uint32_t leaf = wordAt(bytes, root + 4);
    // Inserts a node between root and first leaf: the first entry of the leaf, with an empty leaf below it.
    const auto node = static_cast<std::uint32_t>(bytes.size());
    bytes.resize(bytes.size() + 4 * 1024);
    const std::uint32_t empty = node + 2 * 1024;
    putWord(bytes, node, node + 1024);
    putWord(bytes, empty, empty + 1024);
    const std::uint32_t count = wordAt(bytes, leaf + kNodeCountAt);
    const std::size_t last = inNode(leaf, 252 + (count - 1) * 24);
    std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(last), 24,
                bytes.begin() + static_cast<std::ptrdiff_t>(node + kNodeEntriesAt));
    putWord(bytes, leaf + kNodeCountAt, count - 1);
    putWord(bytes, node + kNodeCountAt, 1);
    putWord(bytes, node + 4, leaf);
    putWord(bytes, node + 8, empty);
    putWord(bytes, root + 4, node);
    putWord(bytes, kFileSizeAt, static_cast<std::uint32_t>(bytes.size()));
    const auto file = File::fromBytes(bytes, "uneven.dat");
    ASSERT_TRUE(file) << file.error().message();
    std::vector<std::string> warnings;
    RecordId next = 1;
    const auto walked = file->forEach(
        [&](const Entry& entry) { return entry.id == next++ || entry.id == kIterationId; }, &warnings);
    ASSERT_TRUE(walked) << walked.error().message();
    EXPECT_EQ(next, 202u);
    EXPECT_THAT(warnings, testing::ElementsAre(HasSubstr("unequal depths")));
}

TEST(ContainerRules, treesDeeperThanTheLimitAreRefused) {
    Bytes bytes = portalFile(1, 10);
    // A chain of 20 nodes of one entry, each the left branch of the one above.
    const auto first = static_cast<std::uint32_t>(bytes.size());
    bytes.resize(bytes.size() + 40 * 2048);
    for (std::uint32_t i = 0; i < 40; ++i)
        putWord(bytes, first + i * 2048, first + i * 2048 + 1024);
    for (std::uint32_t i = 0; i < 20; ++i) {
        const std::uint32_t node = first + i * 2048;
        putWord(bytes, node + kNodeCountAt, 1);
        putWord(bytes, node + kNodeEntriesAt + 4, 1000 - i);
        putWord(bytes, node + 4, i == 19 ? 0 : node + 2048);
        putWord(bytes, node + 8, first + (20 + i) * 2048);
    }
    putWord(bytes, kRootAt, first);
    EXPECT_THAT(walkError(bytes).what, HasSubstr("deeper than 16"));
    const auto file = File::fromBytes(bytes, "bad.dat");
    const auto found = file->find(1);
    ASSERT_FALSE(found);
    EXPECT_THAT(found.error().what, HasSubstr("deeper than 16"));
}

TEST(ContainerRules, compressedRecordsAreUnpacked) {
    Writer writer(FileTraits::cell());
    const Bytes payload(10000, std::byte{7});
    writer.add(5, payload, true);
    writer.add(6, Bytes{}, true);
    const auto file = File::fromBytes(writer.build(), "z.dat");
    ASSERT_TRUE(file);
    EXPECT_LT((*file->find(5))->size, 200u);
    EXPECT_EQ((*file->find(5))->flags, 1);
    Bytes scratch;
    const auto read = file->read(5, scratch);
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_TRUE(std::equal(read->begin(), read->end(), payload.begin(), payload.end()));
    ASSERT_TRUE(file->read(6, scratch));
    EXPECT_TRUE(file->read(6, scratch)->empty());
}

TEST(ContainerRules, damagedCompressedRecordsAreRefused) {
    Writer writer(FileTraits::portal());
    Bytes payload(300);
    for (std::size_t i = 0; i < payload.size(); ++i)
        payload[i] = static_cast<std::byte>(i * i >> 3);
    writer.add(1, payload, true);
    const Bytes good = writer.build();
    const std::uint32_t at = wordAt(good, entryAt(good, 1) + 8) + 4;
    const auto withSize = [&](std::uint32_t size) {
        Bytes bytes = good;
        putWord(bytes, at, size);
        return bytes;
    };
    EXPECT_THAT(readError(withSize(299), 1).what, HasSubstr("do not unpack to the 299 bytes"));
    EXPECT_THAT(readError(withSize(301), 1).what, HasSubstr("do not unpack to the 301 bytes"));
    EXPECT_THAT(readError(withSize(0xFFFFFFFF), 1).what, HasSubstr("claims to unpack"));
    EXPECT_THAT(readError(withSize((64u << 20) + 1), 1).what, HasSubstr("claims to unpack"));
    Bytes damaged = good;
    damaged[at + 20] ^= std::byte{0x55};
    EXPECT_FALSE(readError(damaged, 1).what.empty());
    Bytes longer = good;
    putWord(longer, entryAt(good, 1) + 12, wordAt(good, entryAt(good, 1) + 12) + 1);
    EXPECT_THAT(readError(longer, 1).what, HasSubstr("do not unpack"));
    Bytes tiny = good;
    putWord(tiny, entryAt(good, 1) + 12, 4);
    EXPECT_THAT(readError(tiny, 1).what, HasSubstr("only 4 bytes"));
}

} // namespace
} // namespace limen::dat
