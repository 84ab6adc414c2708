#pragma once

#include "dat/Codec.h"

#include <bit>
#include <cstring>
#include <string>
#include <type_traits>

namespace limen::dat {

static_assert(std::endian::native == std::endian::little,
              "dat files are little-endian and are copied as they are");

/// Reads a record's payload from front to back. It keeps the first failure and its offset. After a failure
/// all values read as zero and no bytes remain, so callers need not test after every field. ByteWriter has
/// the same members, so one description of a record's layout serves reading and writing.
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

    /// Stores the first failure, at `offset`. Later failures are consequences and are ignored.
    void failAt(std::size_t offset, std::string reason, ErrorCode code = ErrorCode::Malformed);
    void fail(std::string reason, ErrorCode code = ErrorCode::Malformed) {
        failAt(offset(), std::move(reason), code);
    }

    /// Reads an integer, float or enumeration as stored.
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

    /// Reads `count` items, without a stored count, in one copy.
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

    /// Reads a list of `count` items of at least `minItemBytes` each; `item` reads one. Allocates nothing for
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
    /// Reads a list behind its count, stored as a `Count`.
    template <class Count, class List, class Item>
    void list(List& out, std::size_t minItemBytes, const char* what, Item&& item) {
        items(out, count<Count>(what), minItemBytes, what, std::forward<Item>(item));
    }

    /// Reads a count, which must not be negative.
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
    /// Reads a count in 1, 2 or 4 bytes (docs/formats/primitives.md#packed-counts). Refuses one in more bytes than it
    /// needs, because encode would write fewer.
    [[nodiscard]] std::uint32_t packedCount();

    /// Reads a "legacy string": length, bytes, zeros up to a multiple of 4.
    void text(std::string& out);
    /// Skips zeros to the next multiple of 4. Refuses other bytes.
    void alignZero();
    /// Reads the bytes up to the next multiple of 4.
    template <std::size_t N>
    void align(std::array<std::uint8_t, N>& out) {
        const std::size_t gap = (0 - offset()) & 3;
        static_assert(N <= 3);
        take(out.data(), std::min(gap, N));
    }
    [[nodiscard]] ByteView bytes(std::size_t count);

    /// True if `count` items of at least `minItemBytes` can follow; otherwise fails.
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
