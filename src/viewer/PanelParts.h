#pragma once

#include "viewer/Panel.h"

#include <imgui.h>

// The parts that Panel draws inside a Dear ImGui frame. Private to Panel's files.
namespace limen::viewer::panel {

inline void line(const std::string& text) {
    ImGui::TextUnformatted(text.c_str());
}

/// Scales a length designed for a font of 13 units to the current font.
inline float scaled(float length) {
    return length * ImGui::GetFontSize() / 13.0f;
}

inline ImU32 inkOf(output::Rgb rgb, int opacity) {
    return IM_COL32(rgb[0], rgb[1], rgb[2], opacity);
}

/// Converts NDC to window coordinates.
inline ImVec2 screenPoint(const Vec2& ndc) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    return {static_cast<float>(ndc.x * 0.5 + 0.5) * size.x, static_cast<float>(0.5 - ndc.y * 0.5) * size.y};
}

/// Draws lines over the picture: outlines of visits, portals, the pyramids of a frozen flood.
void drawLines(const PanelFacts& facts, const OverlaySwitches& switches);
/// Draws texts over the picture: the use key at a door in reach, the notice, the greeting.
void drawBanners(const PanelFacts& facts, const OverlaySwitches& switches);
/// Draws the key help. A click on a key rebinds it.
void drawHelp(const PanelFacts& facts, PanelChoice& choice);
/// Draws the panel. `choice` holds the current values.
PanelChoice drawPanel(const PanelFacts& facts, PanelChoice choice);

} // namespace limen::viewer::panel
