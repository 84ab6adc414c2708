#include "output/Npy.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <string>

namespace limen::output {
namespace {

/// The parts of an encoded file: the header's text, and the elements after it.
struct NpyContents {
    std::string header;
    std::span<const std::byte> data;
};

NpyContents readNpy(std::span<const std::byte> bytes) {
    EXPECT_GE(bytes.size(), 10u);
    EXPECT_EQ(std::memcmp(bytes.data(), "\x93NUMPY\x01\x00", 8), 0);
    const std::size_t length =
        std::to_integer<std::size_t>(bytes[8]) + 256 * std::to_integer<std::size_t>(bytes[9]);
    EXPECT_EQ((10 + length) % 64, 0u);
    const auto* text = reinterpret_cast<const char*>(bytes.data());
    EXPECT_EQ(text[10 + length - 1], '\n');
    return {std::string(text + 10, length), bytes.subspan(10 + length)};
}

TEST(Npy, writesIdsAsLittleEndianUint32InRows) {
    const std::vector<std::uint32_t> ids{0, 1, 2, 0x01020304, 5, 0xFFFFFFFF};
    const std::vector<std::byte> bytes = encodeNpy(3, 2, ids);
    const NpyContents contents = readNpy(bytes);
    EXPECT_EQ(contents.header.substr(0, contents.header.find('}') + 1),
              "{'descr': '<u4', 'fortran_order': False, 'shape': (2, 3), }");
    ASSERT_EQ(contents.data.size(), 24u);
    EXPECT_EQ(std::memcmp(contents.data.data(), ids.data(), 24), 0);
    EXPECT_EQ(std::to_integer<int>(contents.data[12]), 4); // low byte first
}

TEST(Npy, keepsInfinityAndNaNOfDepth) {
    const std::vector<float> depth{1.5f, std::numeric_limits<float>::infinity(),
                                   std::numeric_limits<float>::quiet_NaN()};
    const std::vector<std::byte> bytes = encodeNpy(1, 3, depth);
    const NpyContents contents = readNpy(bytes);
    EXPECT_NE(contents.header.find("'<f4'"), std::string::npos);
    EXPECT_NE(contents.header.find("(3, 1)"), std::string::npos);
    float read[3];
    ASSERT_EQ(contents.data.size(), sizeof read);
    std::memcpy(read, contents.data.data(), sizeof read);
    EXPECT_EQ(read[0], 1.5f);
    EXPECT_TRUE(std::isinf(read[1]) && read[1] > 0);
    EXPECT_TRUE(std::isnan(read[2]));
}

} // namespace
} // namespace limen::output
