#include "dat/Hex.h"
#include "dat/RandomRecords.h"
#include "dat/RecordTypes.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

namespace limen::dat {
namespace {

template <class Record>
RecordId idIn(const Record& record) {
    if constexpr (requires { record.id; })
        return record.id;
    else
        return 0x08000001;
}

template <class Record>
class RoundTrip : public testing::Test {};

TYPED_TEST_SUITE(RoundTrip, RecordTypes::As<testing::Types>);

TYPED_TEST(RoundTrip, randomRecordsEncodeToTheSameBytesAgain) {
    const bool holds = rc::check("encode(decode(encode(r))) == encode(r)", [](std::uint64_t seed) {
        const auto record = RandomRecords(seed).make<TypeParam>();
        const Bytes bytes = *encode(record);
        const auto again = decode<TypeParam>(idIn(record), bytes);
        RC_ASSERT(again.has_value());
        RC_ASSERT(*encode(*again) == bytes);
    });
    EXPECT_TRUE(holds);
}

TYPED_TEST(RoundTrip, damagedBytesAreRefusedOrEncodeToTheSameAgain) {
    const bool holds = rc::check("decode refuses, or encode gives the bytes back", [](std::uint64_t seed) {
        const auto record = RandomRecords(seed).make<TypeParam>();
        Bytes bytes = *encode(record);
        const auto position = *rc::gen::inRange<std::size_t>(0, bytes.size());
        const auto value = *rc::gen::inRange<int>(0, 256);
        bytes[position] = static_cast<std::byte>(value);
        if (const auto again = decode<TypeParam>(idIn(record), bytes))
            RC_ASSERT(*encode(*again) == bytes);
    });
    EXPECT_TRUE(holds);
}

TYPED_TEST(RoundTrip, everyShorterOrLongerPayloadIsRefused) {
    const auto record = RandomRecords(7, 3).make<TypeParam>();
    Bytes bytes = *encode(record);
    for (std::size_t n = 0; n < bytes.size(); n += 1 + bytes.size() / 500) {
        const auto cut = decode<TypeParam>(idIn(record), ByteView(bytes).first(n));
        ASSERT_FALSE(cut.has_value()) << n << " of " << bytes.size();
        EXPECT_NE(cut.error().where.find("offset 0x"), std::string::npos);
    }
    bytes.push_back(std::byte{0});
    EXPECT_FALSE(decode<TypeParam>(idIn(record), bytes).has_value());
}

TYPED_TEST(RoundTrip, anotherIdThanTheKeyIsRefused) {
    if constexpr (requires(TypeParam r) { r.id; }) {
        const auto record = RandomRecords(3).make<TypeParam>();
        const auto other = decode<TypeParam>(record.id ^ 1, *encode(record));
        ASSERT_FALSE(other.has_value());
        EXPECT_NE(other.error().what.find("id"), std::string::npos) << other.error().message();
    }
}

} // namespace
} // namespace limen::dat
