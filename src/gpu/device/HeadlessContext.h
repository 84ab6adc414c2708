#pragma once

#include "core/Error.h"

namespace limen::gpu {

/// Compatibility contexts also have the fixed functions of OpenGL 1. This library itself needs none of them.
enum class ContextProfile { Core, Compatibility };

/// OpenGL 4.5 context without window or display, current on the creating thread until it is destroyed or
/// another context is made current. Uses EGL: Mesa's surfaceless platform, else the first device with a
/// context. The only code in this room that depends on Linux.
class HeadlessContext {
public:
    /// `debug`: create a debug context (see DebugOutput). Errors: Driver, with EGL's last error.
    [[nodiscard]] static Result<HeadlessContext> create(bool debug = false,
                                                        ContextProfile profile = ContextProfile::Core);
    HeadlessContext(HeadlessContext&& other) noexcept;
    HeadlessContext& operator=(HeadlessContext&& other) noexcept;
    ~HeadlessContext();

    /// Makes the context current on the calling thread, after another one was. Errors: Driver.
    [[nodiscard]] Result<void> makeCurrent();

private:
    HeadlessContext(void* display, void* context) : display_(display), context_(context) {}
    void* display_ = nullptr; // EGLDisplay; shared by the process and never terminated
    void* context_ = nullptr; // EGLContext
};

} // namespace limen::gpu
