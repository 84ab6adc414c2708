#include "viewer/Style.h"

#include "core/platform/FileView.h"

#include <imgui.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <utility>

namespace limen::viewer {
namespace {

namespace fs = std::filesystem;

ImVec4 rgba(int hex, float opacity = 1.0f) {
    return {static_cast<float>(hex >> 16 & 255) / 255.0f, static_cast<float>(hex >> 8 & 255) / 255.0f,
            static_cast<float>(hex & 255) / 255.0f, opacity};
}

// Slate surfaces, warm white letters, one amber accent. Contrast of text on surface: about 13 to 1.
constexpr int kSurface = 0x14181D, kRaised = 0x2B343E, kHover = 0x3A4653, kPressed = 0x4A5C6D;
constexpr int kLine = 0x3A4550, kLetters = 0xF1EEE6, kDimmed = 0xA9B1B8, kAccent = 0xE3A64B;
constexpr int kGood = 0x7CC68D, kBad = 0xF0837A;

void setColours(ImVec4* colours) {
    constexpr float kPageOpacity = 0.97f;
    colours[ImGuiCol_Text] = rgba(kLetters);
    colours[ImGuiCol_TextDisabled] = rgba(kDimmed);
    colours[ImGuiCol_WindowBg] = rgba(kSurface, kPageOpacity);
    colours[ImGuiCol_PopupBg] = rgba(kSurface, 0.98f);
    colours[ImGuiCol_ChildBg] = rgba(0x0E1115, 0.6f);
    colours[ImGuiCol_Border] = rgba(kLine, 0.8f);
    for (const ImGuiCol raised : {ImGuiCol_FrameBg, ImGuiCol_Button, ImGuiCol_Header, ImGuiCol_Tab})
        colours[raised] = rgba(kRaised);
    for (const ImGuiCol hovered :
         {ImGuiCol_FrameBgHovered, ImGuiCol_ButtonHovered, ImGuiCol_HeaderHovered, ImGuiCol_TabHovered})
        colours[hovered] = rgba(kHover);
    for (const ImGuiCol pressed :
         {ImGuiCol_FrameBgActive, ImGuiCol_ButtonActive, ImGuiCol_HeaderActive, ImGuiCol_TabActive})
        colours[pressed] = rgba(kPressed);
    for (const ImGuiCol title : {ImGuiCol_TitleBg, ImGuiCol_TitleBgActive, ImGuiCol_TitleBgCollapsed})
        colours[title] = rgba(kSurface, kPageOpacity);
    for (const ImGuiCol accent : {ImGuiCol_CheckMark, ImGuiCol_SliderGrabActive, ImGuiCol_PlotHistogram,
                                  ImGuiCol_PlotLines, ImGuiCol_NavHighlight})
        colours[accent] = rgba(kAccent);
    colours[ImGuiCol_SliderGrab] = rgba(kAccent, 0.5f); // the number is drawn over it
    colours[ImGuiCol_Separator] = rgba(kLine);
    colours[ImGuiCol_ScrollbarBg] = rgba(kSurface, 0.0f);
    colours[ImGuiCol_ScrollbarGrab] = rgba(kHover);
    colours[ImGuiCol_TableHeaderBg] = rgba(kRaised);
    colours[ImGuiCol_TableBorderLight] = rgba(kLine, 0.6f);
    colours[ImGuiCol_TextSelectedBg] = rgba(kAccent, 0.35f);
    colours[ImGuiCol_NavWindowingDimBg] = colours[ImGuiCol_ModalWindowDimBg] = rgba(0x000000, 0.3f);
}

/// Letters with accents, Greek, Cyrillic, punctuation, arrows, mathematical signs, simple shapes.
constexpr std::array<ImWchar, 17> kGlyphs{0x0020, 0x024F, 0x0370, 0x03FF, 0x0400, 0x04FF,
                                          0x2010, 0x205E, 0x20A0, 0x20BF, 0x2190, 0x21FF,
                                          0x2200, 0x22FF, 0x25A0, 0x25FF, 0};

/// The bytes of a file in ImGui's memory; null and 0 if it cannot be read or is empty. ImGui must not open it: on Windows it
/// takes the name in the system's code page.
std::pair<void*, int> readForAtlas(const fs::path& file) {
    constexpr std::size_t kMostBytes = std::size_t{1} << 28; // no font file is larger
    const Result<platform::FileView> view = platform::mapFile(file);
    if (!view)
        return {};
    std::pair<void*, int> read;
    if (view->size > 0 && view->size <= kMostBytes) {
        read = {ImGui::MemAlloc(view->size), static_cast<int>(view->size)};
        std::memcpy(read.first, view->data, view->size);
    }
    platform::unmapFile(*view);
    return read;
}

} // namespace

unsigned styleInk(StyleInk ink, float opacity) {
    switch (ink) {
    case StyleInk::Text:
        return ImGui::ColorConvertFloat4ToU32(rgba(kLetters, opacity));
    case StyleInk::Dim:
        return ImGui::ColorConvertFloat4ToU32(rgba(kDimmed, opacity));
    case StyleInk::Accent:
    case StyleInk::Warning:
        return ImGui::ColorConvertFloat4ToU32(rgba(kAccent, opacity));
    case StyleInk::Good:
        return ImGui::ColorConvertFloat4ToU32(rgba(kGood, opacity));
    case StyleInk::Bad:
        return ImGui::ColorConvertFloat4ToU32(rgba(kBad, opacity));
    case StyleInk::KeyCap:
        return ImGui::ColorConvertFloat4ToU32(rgba(kPressed, opacity));
    case StyleInk::Backdrop:
        return ImGui::ColorConvertFloat4ToU32(rgba(0x0B0E11, opacity));
    }
    return 0;
}

void applyStyle(float scale) {
    ImGuiStyle style;
    setColours(style.Colors);
    style.WindowPadding = {14.0f, 12.0f};
    style.FramePadding = {10.0f, 5.0f};
    style.ItemSpacing = {8.0f, 7.0f};
    style.ItemInnerSpacing = {8.0f, 4.0f};
    style.CellPadding = {6.0f, 3.0f};
    style.IndentSpacing = 18.0f;
    style.ScrollbarSize = 12.0f;
    style.GrabMinSize = 12.0f;
    style.WindowRounding = 8.0f;
    style.ChildRounding = style.FrameRounding = style.PopupRounding = style.GrabRounding = 5.0f;
    style.TabRounding = 5.0f;
    style.WindowBorderSize = style.PopupBorderSize = style.ChildBorderSize = 1.0f;
    style.WindowTitleAlign = {0.0f, 0.5f};
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;
}

bool applyFont(const std::optional<fs::path>& file, float pixels) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    ImFontConfig config;
    config.OversampleH = 2;
    config.OversampleV = 1;
    const auto [bytes, size] = file ? readForAtlas(*file) : std::pair<void*, int>();
    if (bytes != nullptr &&
        atlas.AddFontFromMemoryTTF(bytes, size, std::round(pixels), &config, // frees the bytes
                                   kGlyphs.data()) != nullptr)
        return true;
    ImFontConfig own;
    own.SizePixels = std::round(pixels * 13.0f / kLetterSize); // ImGui's own font is made for 13 pixels
    atlas.AddFontDefault(&own);
    return false;
}

} // namespace limen::viewer
