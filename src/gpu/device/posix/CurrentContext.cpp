#include "gpu/device/CurrentContext.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <utility>

namespace limen::gpu {
namespace {

/// The current context of GLX. Null without one, and in a process without GLX, which this code does not load.
void* currentOfGlx() {
    for (const char* name : {"libGLX.so.0", "libGL.so.1"}) {
        void* library = dlopen(name, RTLD_LAZY | RTLD_NOLOAD);
        if (library == nullptr)
            continue;
        void* function = dlsym(library, "glXGetCurrentContext");
        void* context = function == nullptr ? nullptr : reinterpret_cast<void* (*)()>(function)();
        dlclose(library);
        if (context != nullptr)
            return context;
    }
    return nullptr;
}

} // namespace

void* currentContext() {
    void* context = eglGetCurrentContext();
    return context != nullptr ? context : currentOfGlx();
}

Result<ContextSwitch> ContextSwitch::begin() {
    const Former former{eglGetCurrentDisplay(), eglGetCurrentContext(), eglGetCurrentSurface(EGL_DRAW),
                        eglGetCurrentSurface(EGL_READ)};
    if (former.context == nullptr && currentOfGlx() != nullptr)
        return fail(ErrorCode::Driver, "EGL",
                    "a GLX context is current on this thread, which EGL could not put back; use another "
                    "thread, or draw in that context");
    return ContextSwitch(former);
}

Result<ContextSwitch> ContextSwitch::to(HeadlessContext& context) {
    Result<ContextSwitch> begun = begin();
    if (begun)
        if (Result<void> current = context.makeCurrent(); !current)
            return Failure(current.error());
    return begun;
}

ContextSwitch::ContextSwitch(ContextSwitch&& other) noexcept
    : former_(other.former_), isActive_(std::exchange(other.isActive_, false)) {}

ContextSwitch::~ContextSwitch() {
    if (!isActive_)
        return;
    if (former_.context != nullptr)
        eglMakeCurrent(former_.display, former_.draw, former_.read, former_.context);
    else if (EGLDisplay display = eglGetCurrentDisplay(); display != EGL_NO_DISPLAY)
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

} // namespace limen::gpu
