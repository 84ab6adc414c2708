// The engine in an OpenGL program: GLFW opens the window, Limen draws a world into it, and the program draws a triangle of
// its own on top, with a shader and a vertex array that stay bound all the time.
//
//     overlay                 a window; the eye turns around
//     overlay FILE.png        draws one frame into a file

#include <limen/engine/FrameDrawer.h>

#include <epoxy/gl.h>

#include <GLFW/glfw3.h>

#include <png.h>

#include <cstdio>
#include <vector>

namespace engine = limen::engine;

namespace {

constexpr std::uint32_t kWidth = 640, kHeight = 360;

GLuint compile(GLenum kind, const char* source) {
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    return shader;
}

/// Makes the program of an orange triangle, and binds it.
void bindTriangle() {
    const GLuint program = glCreateProgram();
    glAttachShader(program, compile(GL_VERTEX_SHADER,
                                    "#version 450\n"
                                    "const vec2 kCorners[] = {{-0.9, -0.9}, {-0.6, -0.9}, {-0.75, -0.5}};\n"
                                    "void main() { gl_Position = vec4(kCorners[gl_VertexID], 0, 1); }\n"));
    glAttachShader(program, compile(GL_FRAGMENT_SHADER, "#version 450\n"
                                                        "layout(location = 0) out vec4 colour;\n"
                                                        "void main() { colour = vec4(1, 0.5, 0, 1); }\n"));
    glLinkProgram(program);
    glUseProgram(program);
    GLuint vertices = 0;
    glCreateVertexArrays(1, &vertices);
    glBindVertexArray(vertices);
}

/// Draws the world, and the triangle on top, into the window.
limen::Result<void> drawBoth(engine::FrameDrawer& drawer, const engine::FrameDescription& frame) {
    if (const auto counts = drawer.draw(frame); !counts)
        return limen::Failure(counts.error());
    if (auto copied = drawer.copyTo(0); !copied)
        return copied;
    glDrawArrays(GL_TRIANGLES, 0, 3);
    return {};
}

limen::Result<void> writeWindow(const char* file) {
    std::vector<std::uint8_t> rgb(std::size_t{kWidth} * kHeight * 3);
    glReadPixels(0, 0, kWidth, kHeight, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = kWidth;
    image.height = kHeight;
    image.format = PNG_FORMAT_RGB;
    // OpenGL's first row is the lowest: a negative stride.
    if (png_image_write_to_file(&image, file, 0, rgb.data(), -static_cast<png_int_32>(kWidth * 3), nullptr) ==
        0)
        return limen::fail(limen::ErrorCode::Unreadable, file, image.message);
    return {};
}

limen::Result<void> run(GLFWwindow* window, const char* file) {
    const auto world = engine::OpenedWorld::open();
    if (!world)
        return limen::Failure(world.error());
    const auto eye = world->viewpoint("inn.hall");
    if (!eye)
        return limen::Failure(eye.error());
    auto drawer = engine::FrameDrawer::onCurrentContext(*world, {.radius = 1});
    if (!drawer)
        return limen::Failure(drawer.error());
    engine::FrameDescription frame{.viewpoint = *eye, .width = kWidth, .height = kHeight};
    bindTriangle();
    if (file != nullptr) {
        auto drawn = drawBoth(*drawer, frame);
        return drawn ? writeWindow(file) : drawn;
    }
    while (!glfwWindowShouldClose(window)) {
        frame.seconds = glfwGetTime();
        frame.viewpoint.yaw = eye->yaw + 10.0 * frame.seconds;
        if (auto drawn = drawBoth(*drawer, frame); !drawn)
            return drawn;
        glfwSwapBuffers(window);
        glfwPollEvents();
    }
    return {};
}

} // namespace

int main(int argc, char** argv) {
    const char* file = argc > 1 ? argv[1] : nullptr;
    if (!glfwInit())
        return 2;
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
    glfwWindowHint(GLFW_VISIBLE, file == nullptr);
    GLFWwindow* window = glfwCreateWindow(kWidth, kHeight, "Limen: overlay", nullptr, nullptr);
    if (window == nullptr)
        return 2;
    glfwMakeContextCurrent(window);
    const auto done = run(window, file); // the drawer ends before its context
    if (!done)
        std::fprintf(stderr, "overlay: %s\n", done.error().message().c_str());
    glfwDestroyWindow(window);
    glfwTerminate();
    return done ? 0 : 2;
}
