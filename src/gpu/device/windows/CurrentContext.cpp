#include "gpu/device/CurrentContext.h"

#include <epoxy/wgl.h>
#include <utility>

namespace limen::gpu {

void* currentContext() {
    return wglGetCurrentContext();
}

Result<ContextSwitch> ContextSwitch::begin() {
    return ContextSwitch({nullptr, wglGetCurrentContext(), wglGetCurrentDC(), nullptr});
}

Result<ContextSwitch> ContextSwitch::to(HeadlessContext& context) {
    Result<ContextSwitch> begun = begin();
    if (Result<void> current = context.makeCurrent(); !current)
        return Failure(current.error());
    return begun;
}

ContextSwitch::ContextSwitch(ContextSwitch&& other) noexcept
    : former_(other.former_), isActive_(std::exchange(other.isActive_, false)) {}

ContextSwitch::~ContextSwitch() {
    if (isActive_)
        wglMakeCurrent(static_cast<HDC>(former_.draw), static_cast<HGLRC>(former_.context));
}

} // namespace limen::gpu
