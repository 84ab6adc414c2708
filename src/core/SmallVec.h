#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace limen {

/// A vector that stores up to `N` elements inside itself and uses the heap only for more. For the many short
/// lists of file records: one allocation for each would cost more than reading it. The interface is a part of
/// std::vector's. Elements are plain values (numbers, glm vectors, small structs).
template <class T, std::uint32_t N>
class SmallVec {
    static_assert(std::is_trivially_destructible_v<T> && std::is_standard_layout_v<T> && N > 0);

public:
    using value_type = T;
    using size_type = std::size_t;
    using difference_type = std::ptrdiff_t;
    using reference = T&;
    using const_reference = const T&;
    using iterator = T*;
    using const_iterator = const T*;

    SmallVec() noexcept = default;
    explicit SmallVec(size_type count, const T& value = T{}) { resize(count, value); }
    SmallVec(std::initializer_list<T> items) { assign(items.begin(), items.end()); }
    SmallVec(const std::vector<T>& items) { assign(items.begin(), items.end()); } // NOLINT: meant to convert
    template <std::forward_iterator It>
    SmallVec(It first, It last) {
        assign(first, last);
    }
    SmallVec(const SmallVec& other) { assign(other.begin(), other.end()); }
    SmallVec(SmallVec&& other) noexcept { take(other); }
    SmallVec& operator=(const SmallVec& other) {
        if (this != &other)
            assign(other.begin(), other.end());
        return *this;
    }
    SmallVec& operator=(SmallVec&& other) noexcept {
        if (this != &other) {
            release();
            take(other);
        }
        return *this;
    }
    SmallVec& operator=(std::initializer_list<T> items) {
        assign(items.begin(), items.end());
        return *this;
    }
    ~SmallVec() { release(); }

    /// Replaces the content; the range may not lie inside this vector.
    template <std::forward_iterator It>
    void assign(It first, It last) {
        const auto count = static_cast<size_type>(std::distance(first, last));
        size_ = 0;
        reserve(count);
        std::uninitialized_copy(first, last, data());
        size_ = static_cast<std::uint32_t>(count);
    }
    void assign(size_type count, const T& value) {
        const T kept = value;
        size_ = 0;
        resize(count, kept);
    }

    [[nodiscard]] T* data() noexcept { return onHeap() ? storage_.heap : storage_.items; }
    [[nodiscard]] const T* data() const noexcept { return onHeap() ? storage_.heap : storage_.items; }
    [[nodiscard]] size_type size() const noexcept { return size_; }
    [[nodiscard]] size_type capacity() const noexcept { return capacity_; }
    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }

    [[nodiscard]] iterator begin() noexcept { return data(); }
    [[nodiscard]] iterator end() noexcept { return data() + size_; }
    [[nodiscard]] const_iterator begin() const noexcept { return data(); }
    [[nodiscard]] const_iterator end() const noexcept { return data() + size_; }

    [[nodiscard]] T& operator[](size_type i) noexcept { return data()[i]; }
    [[nodiscard]] const T& operator[](size_type i) const noexcept { return data()[i]; }
    [[nodiscard]] T& front() noexcept { return data()[0]; }
    [[nodiscard]] const T& front() const noexcept { return data()[0]; }
    [[nodiscard]] T& back() noexcept { return data()[size_ - 1]; }
    [[nodiscard]] const T& back() const noexcept { return data()[size_ - 1]; }

    void reserve(size_type count) {
        if (count > capacity_)
            grow(count);
    }
    void resize(size_type count, const T& value = T{}) {
        reserve(count);
        if (count > size_)
            std::uninitialized_fill(data() + size_, data() + count, value);
        size_ = static_cast<std::uint32_t>(count);
    }
    void push_back(const T& value) {
        const T kept = value; // NOLINT(performance-*): it may be an element that grow() moves
        if (size_ == capacity_)
            grow(size_type{size_} + 1);
        std::construct_at(data() + size_, kept);
        ++size_;
    }
    template <class... Args>
    T& emplace_back(Args&&... args) {
        push_back(T(std::forward<Args>(args)...));
        return back();
    }
    void pop_back() noexcept { --size_; }
    void clear() noexcept { size_ = 0; }

    friend bool operator==(const SmallVec& a, const SmallVec& b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end());
    }

private:
    union Storage {
        Storage() noexcept : heap(nullptr) {}
        T items[N];
        T* heap;
    };

    [[nodiscard]] bool onHeap() const noexcept { return capacity_ > N; }

    void grow(size_type needed) {
        const size_type count = std::max(needed, size_type{capacity_} * 2);
        T* fresh = std::allocator<T>{}.allocate(count);
        std::uninitialized_copy(begin(), end(), fresh);
        release();
        storage_.heap = fresh;
        capacity_ = static_cast<std::uint32_t>(count);
    }
    void release() noexcept {
        if (onHeap())
            std::allocator<T>{}.deallocate(storage_.heap, capacity_);
    }
    /// Moves the content of `other` here and leaves it empty. Requires release() before.
    void take(SmallVec& other) noexcept {
        if (other.onHeap())
            storage_.heap = other.storage_.heap;
        else
            std::uninitialized_copy(other.storage_.items, other.storage_.items + other.size_, storage_.items);
        size_ = std::exchange(other.size_, 0);
        capacity_ = std::exchange(other.capacity_, N);
    }

    Storage storage_;
    std::uint32_t size_ = 0;
    std::uint32_t capacity_ = N;
};

} // namespace limen
