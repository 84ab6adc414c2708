#pragma once

#include "core/Error.h"

namespace limen::gpu {

/// Compatibility contexts also have the fixed functions of OpenGL 1. This library itself needs none of them.
enum class ContextProfile { Core, Compatibility };

/// The driver keeps a screen for each display. SoftwareDevice: that of the device that rasterises on the CPU. Contexts of
/// Default are not on it where Mesa's surfaceless platform exists, so two threads share no screen. Without such a device: as Default.
enum class ContextDisplay { Default, SoftwareDevice };

/// OpenGL 4.5 context without window or display, current on the creating thread until it is destroyed or
/// another context is made current. On Linux it uses EGL: Mesa's surfaceless platform, else the first device with a
/// context. On Windows it uses WGL and a window that is never shown. Only this code depends on the system.
class HeadlessContext {
public:
    /// `debug`: create a debug context (see DebugOutput). Errors: Driver, with the last error of EGL or Windows.
    [[nodiscard]] static Result<HeadlessContext> create(bool debug = false,
                                                        ContextProfile profile = ContextProfile::Core,
                                                        ContextDisplay display = ContextDisplay::Default);
    HeadlessContext(HeadlessContext&& other) noexcept;
    HeadlessContext& operator=(HeadlessContext&& other) noexcept;
    ~HeadlessContext();

    /// Makes the context current on the calling thread, after another one was. Errors: Driver.
    [[nodiscard]] Result<void> makeCurrent();

private:
    HeadlessContext(void* display, void* context) : display_(display), context_(context) {}
    void* display_ =
        nullptr; // EGLDisplay, shared by the process and never terminated; or a window of its own
    void* context_ = nullptr; // EGLContext or HGLRC
};

} // namespace limen::gpu
