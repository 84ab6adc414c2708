#include "viewer/Overlay.h"

#include "core/platform/Process.h"
#include "engine/UserFiles.h"
#include "viewer/Style.h"

#include <epoxy/gl.h>

#include <GLFW/glfw3.h>
#include <algorithm>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <cmath>

namespace limen::viewer {

/// The texture of a picture that covers the frame.
struct Overlay::OverTexture {
    GLuint name = 0;
    std::uint32_t width = 0, height = 0;
    ~OverTexture() { glDeleteTextures(1, &name); }

    void write(const output::Picture& picture) {
        if (name == 0 || width != picture.width || height != picture.height) {
            glDeleteTextures(1, &name);
            glCreateTextures(GL_TEXTURE_2D, 1, &name);
            width = picture.width;
            height = picture.height;
            glTextureStorage2D(name, 1, GL_RGB8, static_cast<GLsizei>(width), static_cast<GLsizei>(height));
            glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
            glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        }
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTextureSubImage2D(name, 0, 0, 0, static_cast<GLsizei>(width), static_cast<GLsizei>(height), GL_RGB,
                            GL_UNSIGNED_BYTE, picture.rgb.data());
        glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    }
};

Overlay::Overlay(const Window& window)
    : over_(std::make_unique<OverTexture>()), window_(window),
      font_(engine::findFont(engine::fontPaths(platform::programPath()))) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;                // no file of window positions
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), true); // chains to the window's own callbacks
    ImGui_ImplOpenGL3_Init("#version 450 core");
    ImGui_ImplOpenGL3_CreateDeviceObjects(); // now: fitScale can rebuild the font before the first frame
}

Overlay::~Overlay() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

namespace {

/// Passes keys to ImGui. A key that was pressed and released between two frames counts for one frame; ImGui's
/// backend loses it.
void passKeys(const Window& window, ImGuiIO& io) {
    for (const KeyName& key : kKeyNames) {
        const int code = static_cast<int>(key.code);
        const auto& pressed = window.pressedKeys();
        io.KeysDown[code] = glfwGetKey(window.handle(), code) == GLFW_PRESS ||
                            std::find(pressed.begin(), pressed.end(), key.code) != pressed.end();
    }
}

} // namespace

Taken Overlay::takes() const {
    return {ImGui::GetIO().WantCaptureMouse, ImGui::GetIO().WantTextInput};
}

void Overlay::fitScale(double scale) {
    const UiScale screen = uiScaleOf(window_.sizes());
    const UiScale wanted{screen.units * scale, screen.pixels * scale};
    if (isFitted_ && wanted == scale_)
        return;
    const bool hasFont = applyFont(font_, kLetterSize * static_cast<float>(wanted.pixels));
    ImGui::GetIO().FontGlobalScale = static_cast<float>(wanted.units / wanted.pixels);
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    applyStyle(static_cast<float>(wanted.units));
    fontNote_ = hasFont ? font_->string()
                        : "no font file found: a built-in bitmap font; limen doctor explains the remedy";
    scale_ = wanted;
    isFitted_ = true;
}

void Overlay::begin(double scale, bool selects) {
    fitScale(scale);
    ImGuiIO& io = ImGui::GetIO();
    constexpr ImGuiConfigFlags kSelects =
        ImGuiConfigFlags_NavEnableKeyboard | ImGuiConfigFlags_NavEnableGamepad;
    io.ConfigFlags = (selects ? kSelects : 0) | (window_.isCaptured() ? ImGuiConfigFlags_NoMouse : 0);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    if (window_.isLost()) // GLFW's sizes are arbitrary then, also negative ones, which end ImGui
        io.DisplaySize = io.DisplayFramebufferScale = {1.0f, 1.0f};
    passKeys(window_, io);
    // ImGui activates a selected button with Space only.
    if (selects && !io.WantTextInput && ImGui::IsKeyDown(ImGui::GetKeyIndex(ImGuiKey_Enter)))
        io.NavInputs[ImGuiNavInput_Activate] = 1.0f;
    ImGui::NewFrame();
}

void Overlay::end() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Overlay::clear() {
    const engine::PixelSize size = window_.size();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, static_cast<GLsizei>(size.width), static_cast<GLsizei>(size.height));
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0.043f, 0.055f, 0.067f, 1.0f); // as StyleInk::Backdrop
    glClear(GL_COLOR_BUFFER_BIT);
}

void Overlay::drawOver(const output::Picture& picture, int opacity) {
    over_->write(picture);
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    // ImGui passes the GL name of a texture as a pointer.
    ImGui::GetBackgroundDrawList()->AddImage(
        reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(over_->name)), {0, 0}, size, {0, 0}, {1, 1},
        IM_COL32(255, 255, 255, opacity));
}

} // namespace limen::viewer
