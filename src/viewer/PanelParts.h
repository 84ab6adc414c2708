#pragma once

#include "viewer/Panel.h"

#include <imgui.h>

// What Panel draws between Dear ImGui's begin and end of a frame. For its own files alone.
namespace limen::viewer::panel {

inline void line(const std::string& text) {
    ImGui::TextUnformatted(text.c_str());
}

/// A length for letters of 13 units, for those that there are.
inline float scaled(float length) {
    return length * ImGui::GetFontSize() / 13.0f;
}

inline ImU32 inkOf(output::Rgb rgb, int opacity) {
    return IM_COL32(rgb[0], rgb[1], rgb[2], opacity);
}

/// Where a point of the picture is in the window.
inline ImVec2 screenPoint(const Vec2& ndc) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    return {static_cast<float>(ndc.x * 0.5 + 0.5) * size.x, static_cast<float>(0.5 - ndc.y * 0.5) * size.y};
}

/// Lines in the picture: outlines of visits, portals, the pyramids of a flood that is kept.
void drawLines(const PanelFacts& facts, const OverlaySwitches& switches);
/// Words over the picture: what the key does to the door in reach, what is to be noticed, the greeting.
void drawBanners(const PanelFacts& facts, const OverlaySwitches& switches);
/// What keys do; a click on one changes it.
void drawHelp(const PanelFacts& facts, PanelChoice& choice);
/// The panel itself, section by section. `choice`: as things are.
PanelChoice drawPanel(const PanelFacts& facts, PanelChoice choice);

} // namespace limen::viewer::panel
