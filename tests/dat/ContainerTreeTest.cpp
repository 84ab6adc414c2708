#include "dat/ContainerBytes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// The rows of docs/formats/container.md#damage about the index: a reader refuses damaged trees.
namespace limen::dat {
namespace {

using testing::HasSubstr;

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

} // namespace
} // namespace limen::dat
