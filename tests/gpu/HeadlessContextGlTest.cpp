#include "gpu/device/HeadlessContext.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <gtest/gtest.h>
#include <optional>
#include <string>

namespace limen::gpu::test {
namespace {

/// Whether the current context has the functions of OpenGL 1.
bool hasFixedFunctions() {
    GLint profile = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    return (profile & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) != 0;
}

TEST(HeadlessContext, takesTurnsWithAnother) {
    Result<HeadlessContext> core = HeadlessContext::create();
    ASSERT_TRUE(core) << core.error().message();
    EXPECT_FALSE(hasFixedFunctions());
    Result<HeadlessContext> fixed = HeadlessContext::create(false, ContextProfile::Compatibility);
    ASSERT_TRUE(fixed) << fixed.error().message();
    EXPECT_TRUE(hasFixedFunctions());
    ASSERT_TRUE(core->makeCurrent());
    EXPECT_FALSE(hasFixedFunctions());
    ASSERT_TRUE(fixed->makeCurrent());
    EXPECT_TRUE(hasFixedFunctions());
}

TEST(HeadlessContext, leavesAnotherCurrentWhenItIsDestroyed) {
    std::optional<HeadlessContext> first(std::move(*HeadlessContext::create()));
    Result<HeadlessContext> second = HeadlessContext::create(false, ContextProfile::Compatibility);
    ASSERT_TRUE(second) << second.error().message();
    first.reset();
    EXPECT_TRUE(hasFixedFunctions());
}

std::string renderer() {
    return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

TEST(HeadlessContext, ofTheSoftwareDeviceHasADisplayOfItsOwn) {
    Result<HeadlessContext> first = HeadlessContext::create();
    ASSERT_TRUE(first) << first.error().message();
    const EGLDisplay display = eglGetCurrentDisplay();
    const std::string driver = renderer();
    if (!driver.starts_with("llvmpipe"))
        GTEST_SKIP() << "the driver is " << driver;
    Result<HeadlessContext> second =
        HeadlessContext::create(false, ContextProfile::Core, ContextDisplay::SoftwareDevice);
    ASSERT_TRUE(second) << second.error().message();
    EXPECT_NE(eglGetCurrentDisplay(), display);
    EXPECT_EQ(renderer(), driver);
}

} // namespace
} // namespace limen::gpu::test
