#pragma once

#include "dat/Codec.h"

#include <bit>
#include <cstring>
#include <string>
#include <type_traits>

namespace limen::dat {

static_assert(std::endian::native == std::endian::little,
              "dat files are little-endian and are copied as they are");

/// Reads a record's payload from front to back. The first failure is kept with its offset; from then on
/// everything reads as zero and nothing is left, so callers need not test after every field. Its sibling
/// ByteWriter has the same members, so that one description of a record's layout serves both ways.
class ByteReader {
public:
    static constexpr bool kReading = true;

    explicit ByteReader(ByteView bytes)
        : begin_(bytes.data()), at_(bytes.data()), end_(bytes.data() + bytes.size()) {}

    [[nodiscard]] std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }
    [[nodiscard]] std::size_t remaining() const { return static_cast<std::size_t>(end_ - at_); }
    [[nodiscard]] bool failed() const { return failed_; }
    [[nodiscard]] ErrorCode failureCode() const { return code_; }
    [[nodiscard]] std::size_t failureOffset() const { return failureOffset_; }
    [[nodiscard]] const std::string& failureReason() const { return reason_; }

    /// Notes the first failure, at `offset`; later ones are consequences and are dropped.
    void failAt(std::size_t offset, std::string reason, ErrorCode code = ErrorCode::Malformed);
    void fail(std::string reason, ErrorCode code = ErrorCode::Malformed) {
        failAt(offset(), std::move(reason), code);
    }

    /// An integer, float or enumeration as the file stores it.
    template <class T>
    requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void value(T& out) { take(&out, sizeof(T)); }
    void value(Vec2f& out) { take(&out, sizeof out); }
    void value(Vec3f& out) { take(&out, sizeof out); }
    void value(Quatf& out) {
        float wxyz[4];
        take(wxyz, sizeof wxyz);
        out = Quatf(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
    }
    template <class T>
    [[nodiscard]] T get() {
        T out{};
        value(out);
        return out;
    }

    /// `count` items without a count in front, copied in one piece.
    template <class List>
    void array(List& out, std::size_t count) {
        using T = typename List::value_type;
        static_assert(std::is_standard_layout_v<T> && std::is_trivially_destructible_v<T>);
        if (count > remaining() / sizeof(T)) {
            tooShort(count * sizeof(T));
            return;
        }
        out.resize(count);
        if (count != 0)
            take(out.data(), count * sizeof(T));
    }

    /// A list of `count` items, each at least `minItemBytes` long; `item` reads one. Nothing is allocated for
    /// a count that the remaining bytes cannot hold.
    template <class List, class Item>
    void items(List& out, std::size_t count, std::size_t minItemBytes, const char* what, Item&& item) {
        if (!fits(count, minItemBytes, what))
            return;
        out.resize(count);
        for (auto& one : out) {
            item(one);
            if (failed_)
                return;
        }
    }
    /// The same with the count in front, stored as a `Count`.
    template <class Count, class List, class Item>
    void list(List& out, std::size_t minItemBytes, const char* what, Item&& item) {
        items(out, count<Count>(what), minItemBytes, what, std::forward<Item>(item));
    }

    /// A count: not negative.
    template <class Count>
    [[nodiscard]] std::size_t count(const char* what) {
        const std::size_t start = offset();
        const auto n = get<Count>();
        if constexpr (std::is_signed_v<Count>) {
            if (n < 0) {
                failAt(start, negative(n, what));
                return 0;
            }
        }
        return static_cast<std::size_t>(n);
    }
    /// A count in 1, 2 or 4 bytes (docs/formats/primitives.md#packed-counts); one in more bytes than it needs is refused,
    /// since it would not be written back the same.
    [[nodiscard]] std::uint32_t packedCount();

    /// A "legacy string": length, bytes, zeros up to a multiple of 4.
    void text(std::string& out);
    /// Skips to the next multiple of 4 over zeros; anything else there is refused.
    void alignZero();
    /// The same, but keeps the bytes.
    template <std::size_t N>
    void align(std::array<std::uint8_t, N>& out) {
        const std::size_t gap = (0 - offset()) & 3;
        static_assert(N <= 3);
        take(out.data(), std::min(gap, N));
    }
    /// Raw bytes.
    [[nodiscard]] ByteView bytes(std::size_t count);

    /// True if `count` items of at least `minItemBytes` can follow; else a failure.
    [[nodiscard]] bool fits(std::size_t count, std::size_t minItemBytes, const char* what);

private:
    void take(void* out, std::size_t size) {
        if (size > remaining()) {
            std::memset(out, 0, size);
            tooShort(size);
            return;
        }
        std::memcpy(out, at_, size);
        at_ += size;
    }
    void tooShort(std::size_t size);
    static std::string negative(long long n, const char* what);

    const std::byte* begin_;
    const std::byte* at_;
    const std::byte* end_;
    bool failed_ = false;
    ErrorCode code_ = ErrorCode::Malformed;
    std::size_t failureOffset_ = 0;
    std::string reason_;
};

} // namespace limen::dat
