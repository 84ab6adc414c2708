#pragma once

#include "dat/Codec.h"

#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

namespace limen::dat {

/// Writes a record's payload, with the members of ByteReader. Keeps the first rule of the format that the record breaks.
class ByteWriter {
public:
    static constexpr bool kReading = false;

    [[nodiscard]] std::size_t offset() const { return bytes_.size(); }
    [[nodiscard]] bool failed() const { return broken_ != nullptr; }
    /// `rule`: a literal.
    void require(bool holds, const char* rule) {
        if (!holds && broken_ == nullptr)
            broken_ = rule;
    }
    /// The bytes, or an error with the broken rule.
    [[nodiscard]] Result<Bytes> take(RecordId id) { return takeNamed(idText(id)); }
    [[nodiscard]] Result<Bytes> takeNamed(std::string name);
    void reserve(std::size_t size) { bytes_.reserve(size); }

    template <class T>
    requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void value(const T& in) { put(&in, sizeof(T)); }
    void value(const Vec2f& in) { put(&in, sizeof in); }
    void value(const Vec3f& in) { put(&in, sizeof in); }
    void value(const Quatf& in) {
        const float wxyz[4] = {in.w, in.x, in.y, in.z};
        put(wxyz, sizeof wxyz);
    }

    template <class List>
    void array(const List& in, std::size_t count) {
        require(in.size() == count, kOtherCount);
        if (!in.empty())
            put(in.data(), in.size() * sizeof(typename List::value_type));
    }
    template <class List, class Item>
    void items(const List& in, std::size_t count, std::size_t, const char*, Item&& item) {
        require(in.size() == count, kOtherCount);
        for (const auto& one : in)
            item(one);
    }
    template <class Count, class List, class Item>
    void list(const List& in, std::size_t, const char*, Item&& item) {
        count<Count>(in.size());
        for (const auto& one : in)
            item(one);
    }
    template <class Count>
    void count(std::size_t n) {
        require(n <= static_cast<std::size_t>(std::numeric_limits<Count>::max()),
                "a list is longer than its count can say");
        value(static_cast<Count>(n));
    }
    void packedCount(std::size_t n);

    void text(const std::string& in);
    void alignZero() { bytes_.resize((bytes_.size() + 3) & ~std::size_t{3}); }
    template <std::size_t N>
    void align(const std::array<std::uint8_t, N>& in) {
        const std::size_t gap = (0 - offset()) & 3;
        put(in.data(), std::min(gap, N));
        alignZero();
    }
    void put(const void* in, std::size_t size) {
        const auto* first = static_cast<const std::byte*>(in);
        bytes_.insert(bytes_.end(), first, first + size);
    }

private:
    static constexpr const char* kOtherCount = "a list must have as many items as the record says elsewhere";

    Bytes bytes_;
    const char* broken_ = nullptr;
};

} // namespace limen::dat
