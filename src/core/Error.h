#pragma once

#include "core/Api.h"

#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace limen {

/// The kind of a failure.
enum class ErrorCode {
    NotFound,    ///< a file, record, name or place that does not exist
    Unreadable,  ///< the operating system refused to open, read, map or write
    Malformed,   ///< bytes that contradict the format
    Unsupported, ///< well formed, but beyond this program
    BadArgument, ///< a command line or request that makes no sense
    Driver,      ///< the graphics driver lacks something or failed
};

/// A failure as one sentence for the user: the fault, its place in a file or record, and the expected value
/// or next step.
struct Error {
    ErrorCode code = ErrorCode::Malformed;
    std::string where; ///< file name, and offset or record id where they are known; may be empty
    std::string what;  ///< the fault and the next step, without a full stop

    /// `where`, a colon and `what`.
    [[nodiscard]] LIMEN_API std::string message() const;
};

/// An error on its way out of a function that yields a Result: `return Failure(opened.error());`.
class [[nodiscard]] Failure {
public:
    explicit Failure(Error error) : error_(std::move(error)) {}
    [[nodiscard]] const Error& error() const& { return error_; }
    [[nodiscard]] Error&& error() && { return std::move(error_); }

private:
    Error error_;
};

/// Shorthand for returning an error from a function that yields a Result.
[[nodiscard]] LIMEN_API Failure fail(ErrorCode code, std::string where, std::string what);

template <class T>
class Result;

namespace detail {
template <class Function, class... Args>
using ResultOf = Result<std::remove_cvref_t<std::invoke_result_t<Function, Args...>>>;

/// The value of a call as a Result, also of a function without a value.
template <class Function, class... Args>
ResultOf<Function, Args...> resultOf(Function&& function, Args&&... args) {
    if constexpr (std::is_void_v<std::invoke_result_t<Function, Args...>>) {
        std::invoke(std::forward<Function>(function), std::forward<Args>(args)...);
        return {};
    } else {
        return std::invoke(std::forward<Function>(function), std::forward<Args>(args)...);
    }
}
} // namespace detail

/// A value, or the reason why there is none. The interface is the part of C++23's std::expected that the
/// project uses. `*` and `->` require a value, `error` requires that there is none.
template <class T>
class [[nodiscard]] Result {
public:
    using value_type = T;

    Result() requires std::default_initializable<T> : value_(std::in_place) {}
    template <class... Args>
    explicit Result(std::in_place_t, Args&&... args) : value_(std::in_place, std::forward<Args>(args)...) {}
    template <class U = T>
    requires(std::is_constructible_v<T, U> && !std::same_as<std::remove_cvref_t<U>, Result> &&
             !std::same_as<std::remove_cvref_t<U>, Failure> &&
             !std::same_as<std::remove_cvref_t<U>, std::in_place_t>) explicit(!std::is_convertible_v<U, T>)
        Result(U&& value) // NOLINT: a value is a result
        : value_(std::in_place, std::forward<U>(value)) {}
    Result(Failure failure) // NOLINT: a failure is a result
        : error_(std::move(failure).error()) {}

    [[nodiscard]] bool has_value() const noexcept { return value_.has_value(); }
    [[nodiscard]] explicit operator bool() const noexcept { return has_value(); }

    [[nodiscard]] T& operator*() & noexcept { return *value_; }
    [[nodiscard]] const T& operator*() const& noexcept { return *value_; }
    [[nodiscard]] T&& operator*() && noexcept { return *std::move(value_); }
    [[nodiscard]] T* operator->() noexcept { return &*value_; }
    [[nodiscard]] const T* operator->() const noexcept { return &*value_; }
    /// As `*`; without a value it throws std::bad_optional_access. For tests.
    [[nodiscard]] T& value() & { return value_.value(); }
    [[nodiscard]] const T& value() const& { return value_.value(); }
    [[nodiscard]] T&& value() && { return std::move(value_).value(); }
    template <class U>
    [[nodiscard]] T value_or(U&& other) const& {
        return has_value() ? **this : static_cast<T>(std::forward<U>(other));
    }

    [[nodiscard]] Error& error() & noexcept { return error_; }
    [[nodiscard]] const Error& error() const& noexcept { return error_; }
    [[nodiscard]] Error&& error() && noexcept { return std::move(error_); }

    /// The result of `function` for the value; the same error if there is none.
    template <class Function>
    [[nodiscard]] auto map(Function&& function) && -> detail::ResultOf<Function, T&&> {
        if (!has_value())
            return Failure(std::move(*this).error());
        return detail::resultOf(std::forward<Function>(function), *std::move(*this));
    }
    template <class Function>
    [[nodiscard]] auto map(Function&& function) const& -> detail::ResultOf<Function, const T&> {
        if (!has_value())
            return Failure(error());
        return detail::resultOf(std::forward<Function>(function), **this);
    }
    /// As `map`, for a function that may fail itself.
    template <class Function>
    [[nodiscard]] auto and_then(Function&& function) && -> std::invoke_result_t<Function, T&&> {
        if (!has_value())
            return Failure(std::move(*this).error());
        return std::invoke(std::forward<Function>(function), *std::move(*this));
    }

private:
    std::optional<T> value_;
    Error error_; ///< empty with a value
};

/// Success without a value, or the reason for the failure.
template <>
class [[nodiscard]] Result<void> {
public:
    using value_type = void;

    Result() = default;
    Result(Failure failure) : error_(std::move(failure).error()) {} // NOLINT: a failure is a result

    [[nodiscard]] bool has_value() const noexcept { return !error_.has_value(); }
    [[nodiscard]] explicit operator bool() const noexcept { return has_value(); }
    [[nodiscard]] Error& error() & noexcept { return *error_; }
    [[nodiscard]] const Error& error() const& noexcept { return *error_; }
    [[nodiscard]] Error&& error() && noexcept { return std::move(*error_); }

    /// The result of `function`; the same error if there is one.
    template <class Function>
    [[nodiscard]] auto map(Function&& function) const -> detail::ResultOf<Function> {
        if (!has_value())
            return Failure(*error_);
        return detail::resultOf(std::forward<Function>(function));
    }
    /// As `map`, for a function that may fail itself.
    template <class Function>
    [[nodiscard]] auto and_then(Function&& function) const -> std::invoke_result_t<Function> {
        if (!has_value())
            return Failure(*error_);
        return std::invoke(std::forward<Function>(function));
    }

private:
    std::optional<Error> error_;
};

} // namespace limen
