#pragma once

#include "core/Error.h"
#include "gpu/device/HeadlessContext.h"

namespace limen::gpu {

/// The OpenGL context of the calling thread, for comparison only; null: none. It may be of another library: EGL or GLX on
/// Linux, WGL on Windows.
[[nodiscard]] void* currentContext();

/// Puts the calling thread's context back at its end, for code that makes another one current.
class ContextSwitch {
public:
    /// Remembers the current context, or that there is none. Errors: Driver on Linux, if a GLX context is current, because
    /// EGL cannot put it back.
    [[nodiscard]] static Result<ContextSwitch> begin();
    /// The same, and makes `context` current. Errors: also Driver, if the system refuses.
    [[nodiscard]] static Result<ContextSwitch> to(HeadlessContext& context);
    ContextSwitch(ContextSwitch&& other) noexcept;
    ContextSwitch& operator=(ContextSwitch&&) = delete;
    ~ContextSwitch();

private:
    /// The former context and its surfaces, as the system names them; null: none.
    struct Former {
        void *display = nullptr, *context = nullptr, *draw = nullptr, *read = nullptr;
    };
    explicit ContextSwitch(const Former& former) : former_(former), isActive_(true) {}

    Former former_;
    bool isActive_ = false; ///< false after a move
};

} // namespace limen::gpu
