#pragma once

#include "core/Error.h"

namespace limen::gpu {

/// OpenGL 4.5 core context without window or display, current on the creating thread until destroyed. Uses
/// EGL: Mesa's surfaceless platform, else the first device with a context. The only code in this room that
/// depends on Linux.
class HeadlessContext {
public:
    /// `debug`: create a debug context (see DebugOutput). Errors: Driver, with EGL's last error.
    [[nodiscard]] static Result<HeadlessContext> create(bool debug = false);
    HeadlessContext(HeadlessContext&& other) noexcept;
    HeadlessContext& operator=(HeadlessContext&& other) noexcept;
    ~HeadlessContext();

private:
    HeadlessContext(void* display, void* context) : display_(display), context_(context) {}
    void* display_ = nullptr; // EGLDisplay; shared by the process and never terminated
    void* context_ = nullptr; // EGLContext
};

} // namespace limen::gpu
