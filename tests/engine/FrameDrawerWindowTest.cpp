// Frames of the engine in a window of GLFW, whose context is one of GLX. Runs on an X server (tests/engine/CMakeLists.txt).
#include "engine/FrameDrawer.h"

#include <epoxy/gl.h>

#include <GLFW/glfw3.h>

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limen::engine::test {
namespace {

constexpr int kWindowWidth = 160, kWindowHeight = 90;

/// A window that is not shown, with its context current.
class FrameDrawerInAWindow : public ::testing::Test {
protected:
    void SetUp() override {
        ASSERT_EQ(glfwInit(), GLFW_TRUE) << "is there an X server?";
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_NATIVE_CONTEXT_API);
        glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
        window_ = glfwCreateWindow(kWindowWidth, kWindowHeight, "test", nullptr, nullptr);
        ASSERT_NE(window_, nullptr);
        glfwMakeContextCurrent(window_);
    }
    void TearDown() override { glfwTerminate(); }

    GLFWwindow* window_ = nullptr;
};

FrameDescription hallOf(const OpenedWorld& world) {
    return {.viewpoint = world.viewpoint("inn.hall").value(), .width = kWindowWidth, .height = kWindowHeight};
}

TEST_F(FrameDrawerInAWindow, drawsIntoTheWindow) {
    const OpenedWorld world = OpenedWorld::open().value();
    FrameDrawer drawer = FrameDrawer::onCurrentContext(world, {.radius = 0}).value();
    ASSERT_TRUE(drawer.draw(hallOf(world)));
    ASSERT_TRUE(drawer.copyTo(0));
    std::vector<std::uint8_t> shown(std::size_t{kWindowWidth} * kWindowHeight * 4), turned;
    glReadPixels(0, 0, kWindowWidth, kWindowHeight, GL_RGBA, GL_UNSIGNED_BYTE, shown.data());
    for (int y = kWindowHeight; y-- > 0;)
        turned.insert(turned.end(), shown.begin() + y * kWindowWidth * 4,
                      shown.begin() + (y + 1) * kWindowWidth * 4);
    const std::vector<std::uint8_t> drawn = drawer.readColour().value();
    EXPECT_GT(std::count_if(drawn.begin(), drawn.end(),
                            [](std::uint8_t value) { return value > 40 && value < 200; }),
              10000)
        << "a lit room";
    EXPECT_EQ(turned, drawn);
}

TEST_F(FrameDrawerInAWindow, headlessRefusesToReplaceItsContext) {
    const OpenedWorld world = OpenedWorld::open().value();
    const Result<FrameDrawer> headless = FrameDrawer::headless(world);
    ASSERT_FALSE(headless);
    EXPECT_THAT(headless.error().message(), ::testing::HasSubstr("GLX context is current"));
    EXPECT_EQ(glfwGetCurrentContext(), window_);
    EXPECT_NE(glGetString(GL_VERSION), nullptr) << "the context still works";

    glfwMakeContextCurrent(nullptr);
    FrameDrawer drawer = FrameDrawer::headless(world, {.radius = 0}).value();
    ASSERT_TRUE(drawer.draw(hallOf(world)));
    glfwMakeContextCurrent(window_);
    EXPECT_THAT(drawer.readColour().error().message(), ::testing::HasSubstr("GLX"));
    glfwMakeContextCurrent(nullptr);
    EXPECT_TRUE(drawer.readColour());
}

} // namespace
} // namespace limen::engine::test
