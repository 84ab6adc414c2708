#include "viewer/Panel.h"

#include "output/RegionOverlay.h"
#include "viewer/PanelParts.h"

#include <epoxy/gl.h>

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <cmath>

namespace limen::viewer {

void FrameWindows::add(double now, double frameMs, const engine::FrameFigures& figures) {
    frame.add(now, frameMs);
    stages.resize(figures.stages.size());
    for (std::size_t i = 0; i < stages.size(); ++i) {
        stages[i].cpu.add(now, figures.stages[i].cpuMs);
        stages[i].gpu.add(now, figures.stages[i].gpuMs);
    }
}

/// The texture of a picture that covers the frame.
struct Panel::OverTexture {
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

Panel::Panel(const Window& window) : over_(std::make_unique<OverTexture>()), window_(window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr; // no settings file
    ImGui::StyleColorsDark();
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), true); // chains to the window's own callbacks
    ImGui_ImplOpenGL3_Init("#version 450 core");
    ImGui_ImplOpenGL3_CreateDeviceObjects(); // now: fitScale can rebuild the font before the first frame
}

Panel::~Panel() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

Taken Panel::takes() const {
    return {ImGui::GetIO().WantCaptureMouse, ImGui::GetIO().WantTextInput};
}

void Panel::fitScale() {
    const UiScale wanted = uiScaleOf(window_.sizes());
    if (wanted == scale_)
        return;
    constexpr float kLetters = 13.0f; // pixels, the size of the built-in font
    ImGuiIO& io = ImGui::GetIO();
    ImFontConfig font;
    font.SizePixels = std::round(kLetters * static_cast<float>(wanted.pixels));
    io.Fonts->Clear();
    io.Fonts->AddFontDefault(&font);
    io.FontGlobalScale = static_cast<float>(wanted.units / wanted.pixels);
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    ImGui::GetStyle() = ImGuiStyle();
    ImGui::StyleColorsDark();
    ImGui::GetStyle().ScaleAllSizes(static_cast<float>(wanted.units));
    scale_ = wanted;
}

void Panel::drawOver(const output::Picture& picture, int opacity) {
    over_->write(picture);
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    // ImGui passes the GL name of a texture as a pointer.
    ImGui::GetBackgroundDrawList()->AddImage(
        reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(over_->name)), {0, 0}, size, {0, 0}, {1, 1},
        IM_COL32(255, 255, 255, opacity));
}

PanelChoice Panel::draw(const PanelFacts& facts, const OverlaySwitches& switches) {
    fitScale();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    if (facts.verdict != nullptr)
        drawOver(facts.verdict->picture, 190); // correct pixels stay visible, darkened
    else if (switches.ids && !facts.ids.empty())
        drawOver(output::pictureOfIds(facts.request.size.width, facts.request.size.height, facts.ids), 255);
    else if (switches.depth && !facts.distances.empty())
        drawOver(
            output::pictureOfDistances(facts.request.size.width, facts.request.size.height, facts.distances),
            255);
    panel::drawLines(facts, switches);
    PanelChoice choice;
    choice.time = facts.request.scene.time;
    choice.dayGroup = facts.request.scene.dayGroup;
    choice.weather = facts.request.scene.weather;
    choice.doors = facts.request.scene.doors;
    choice.quality = facts.quality;
    if (switches.panel)
        choice = panel::drawPanel(facts, choice);
    panel::drawBanners(facts, switches);
    if (switches.help)
        panel::drawHelp(facts, choice);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    return choice;
}

} // namespace limen::viewer
