#include "core/Error.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace limen {
namespace {

Result<int> half(int number) {
    if (number % 2 != 0)
        return fail(ErrorCode::BadArgument, "half", "the number is odd");
    return number / 2;
}

Result<void> even(int number) {
    const Result<int> found = half(number);
    if (!found)
        return Failure(found.error());
    return {};
}

TEST(Result, holdsAValueOrAnError) {
    const Result<int> good = half(8), bad = half(7);
    ASSERT_TRUE(good.has_value() && good);
    EXPECT_EQ(*good, 4);
    EXPECT_EQ(good.value(), 4);
    EXPECT_THROW(static_cast<void>(bad.value()), std::bad_optional_access);
    ASSERT_FALSE(bad.has_value() || bad);
    EXPECT_EQ(bad.error().code, ErrorCode::BadArgument);
    EXPECT_EQ(bad.error().message(), "half: the number is odd");
}

TEST(Result, ofVoidIsSuccessByDefault) {
    EXPECT_TRUE(even(2).has_value());
    EXPECT_EQ(even(3).error().what, "the number is odd");
}

TEST(Result, passesAnErrorThroughMapAndAndThen) {
    const auto twice = [](int number) { return std::vector<int>{number, number}; };
    EXPECT_EQ(*half(8).map(twice), (std::vector<int>{4, 4}));
    EXPECT_EQ(half(7).map(twice).error().where, "half");
    EXPECT_EQ(*half(8).and_then(half), 2);
    EXPECT_EQ(half(6).and_then(half).error().where, "half");
    EXPECT_EQ(half(7).and_then(half).error().where, "half");
    EXPECT_EQ(*even(2).map([] { return 5; }), 5);
    EXPECT_FALSE(even(1).map([] { return 5; }).has_value());
    EXPECT_TRUE(even(2).and_then([] { return even(4); }).has_value());
    EXPECT_FALSE(even(2).and_then([] { return even(5); }).has_value());
    int seen = 0;
    EXPECT_TRUE(half(8).map([&](int number) { seen = number; }).has_value());
    EXPECT_EQ(seen, 4);
}

TEST(Result, movesValuesThatCannotBeCopied) {
    Result<std::unique_ptr<int>> made = std::make_unique<int>(3);
    const std::unique_ptr<int> taken = *std::move(made);
    EXPECT_EQ(*taken, 3);
    // NOLINTNEXTLINE(bugprone-use-after-move): a value that was moved from is still a value
    EXPECT_EQ(*std::move(made).map([](std::unique_ptr<int>&& rest) { return rest == nullptr; }), true);
}

TEST(Result, convertsOnlyAsItsValueDoes) {
    static_assert(std::is_convertible_v<const char*, Result<std::string>>);
    static_assert(!std::is_convertible_v<std::size_t, Result<std::vector<int>>>);
    static_assert(std::is_constructible_v<Result<std::vector<int>>, std::size_t>);
    static_assert(!std::is_convertible_v<Error, Result<int>>, "an error is returned as a Failure");
    EXPECT_EQ(half(7).value_or(1), 1);
    EXPECT_EQ(half(8).value_or(1), 4);
}

} // namespace
} // namespace limen
