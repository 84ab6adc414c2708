#include "dat/ContainerBytes.h"
#include "dat/Hex.h"
#include "dat/Iterations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// Every row of docs/formats/container.md#damage: a reader refuses such files, with file and place in the message.
namespace limen::dat {
namespace {

using testing::HasSubstr;

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
    place(0x8FC, "01 00 00 00  00 00 01 00  01 00 FF FF  00 04 00 00  0C 00 00 00  00 00 00 00  05 00 00 00");
    const auto file = File::fromBytes(bytes, "hand.dat");
    ASSERT_TRUE(file) << file.error().message();
    EXPECT_TRUE(file->warnings().empty());
    EXPECT_EQ(file->role(), FileRole::Portal);
    EXPECT_EQ(file->header().engineVersion, 110u);
    EXPECT_EQ(file->header().minorVersion, 6657u);
    const auto entry = file->find(kIterationId);
    ASSERT_TRUE(entry && *entry);
    EXPECT_EQ((*entry)->version, 1);
    EXPECT_EQ((*entry)->iteration, 5);
    Bytes scratch;
    const auto payload = file->read(kIterationId, scratch);
    ASSERT_TRUE(payload);
    EXPECT_EQ(toHex(*payload), "05 00 00 00 FB FF FF FF 01 00 00 00 ");
}

// The writer makes the same file except for the number of the iteration.
TEST(ContainerRules, theWritersSmallestFileHasThatLayout) {
    const Bytes bytes = *Writer(FileTraits::portal()).build();
    EXPECT_EQ(bytes.size(), 0x1000u);
    EXPECT_EQ(wordAt(bytes, 0x140), 0x5442u);
    EXPECT_EQ(wordAt(bytes, kRootAt), 0x800u);
    EXPECT_EQ(wordAt(bytes, 0x404), 1u);
    EXPECT_EQ(wordAt(bytes, 0x800), 0xC00u);
    EXPECT_EQ(wordAt(bytes, 0x8FC), 1u);
    EXPECT_EQ(wordAt(bytes, 0x900), 0x00010000u) << "version 1 is that of the iteration record alone";
    EXPECT_EQ(wordAt(bytes, 0x904), kIterationId);
}

TEST(ContainerRules, recordsHaveVersion2AndTheIterationRecordVersion1) {
    Writer writer(FileTraits::portal());
    writer.add(0x04000001, hex("01 00 00 04  01 00 00 00  33 22 11 FF"));
    const auto file = File::fromBytes(*writer.build(), "made.dat");
    ASSERT_TRUE(file);
    EXPECT_EQ(file->find(0x04000001).value()->version, 2);
    EXPECT_EQ(file->find(kIterationId).value()->version, 1);
}

TEST(ContainerRules, branchesBehindTheLastOneMayHoldAnything) {
    Bytes bytes = portalFile(200, 10);
    const std::uint32_t root = wordAt(bytes, kRootAt);
    const std::uint32_t count = wordAt(bytes, root + kNodeCountAt);
    ASSERT_GT(count, 0u) << "the root has children";
    putWord(bytes, root + 4 + 4 * (count + 1), wordAt(bytes, root + 4)); // an older value, as in retail files
    putWord(bytes, root + 4 + 4 * (count + 2), 0x12345678);
    const auto file = File::fromBytes(bytes, "stale.dat");
    ASSERT_TRUE(file);
    std::size_t seen = 0;
    ASSERT_TRUE(file->forEach([&](const Entry&) { return ++seen, true; }));
    EXPECT_EQ(seen, 201u);
}

TEST(ContainerRules, aNodeIsALeafExactlyWhenItsFirstBranchIs0) {
    Bytes bytes = portalFile(3, 10);
    const std::uint32_t root = wordAt(bytes, kRootAt);
    putWord(bytes, root + 4 + 4, 0x12345678); // branch 1 of a leaf
    const auto file = File::fromBytes(bytes, "leaf.dat");
    ASSERT_TRUE(file);
    EXPECT_TRUE(file->find(kIterationId).value().has_value());
    EXPECT_FALSE(file->find(0x04FFFFFF).value().has_value());
}

TEST(ContainerRules, freeBlocksAreMarkedAndNeverFollowed) {
    Bytes bytes = portalFile(3, 3000);
    const auto entry = File::fromBytes(bytes, "whole.dat")->find(1).value();
    ASSERT_TRUE(entry);
    putWord(bytes, entry->offset, 0x80000000u | (entry->offset + 1024)); // the mark of a free block
    const auto file = File::fromBytes(bytes, "free.dat");
    ASSERT_TRUE(file);
    Bytes scratch;
    EXPECT_FALSE(file->read(1, scratch));
}

TEST(Iterations, areRunsAndSingleValues) {
    const auto retail = decodeIterations(hex("18 08 00 00  E8 F7 FF FF  01 00 00 00"));
    ASSERT_TRUE(retail);
    EXPECT_EQ(*retail, (Iterations{2072, {{1, 2072}}}));
    EXPECT_EQ(toHex(*encodeIterations(*retail)), "18 08 00 00 E8 F7 FF FF 01 00 00 00 ");
    const auto mixed =
        decodeIterations(hex("09 00 00 00  FE FF FF FF  03 00 00 00  07 00 00 00  0B 00 00 00"));
    ASSERT_TRUE(mixed);
    EXPECT_EQ(mixed->runs, (std::vector<IterationRun>{{3, 2}, {7, 1}, {11, 1}}));
    EXPECT_EQ(decodeIterations(*encodeIterations(*mixed)).value(), *mixed);
    EXPECT_FALSE(decodeIterations(hex("09 00 00 00  FE FF FF FF")));
    EXPECT_FALSE(decodeIterations(hex("09 00 00 00  FE FF")));
    EXPECT_FALSE(decodeIterations({}));
}

TEST(ContainerRules, foreignFilesAreNamedForWhatTheyAre) {
    EXPECT_EQ(openError({}).message(), "bad.dat: the file is empty, not a dat file; copy it again");
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

TEST(ContainerRules, compressedRecordsAreUnpacked) {
    Writer writer(FileTraits::cell());
    const Bytes payload(10000, std::byte{7});
    writer.add(5, payload, true);
    writer.add(6, Bytes{}, true);
    const auto file = File::fromBytes(*writer.build(), "z.dat");
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
    const Bytes good = *writer.build();
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
