#pragma once

#include "viewer/Style.h"
#include "viewer/pages/Ui.h"
#include "viewer/panel/PanelFacts.h"

#include <imgui.h>

// The parts that Panel draws inside a Dear ImGui frame. Private to Panel's files.
namespace limen::viewer::panel {

inline void line(const std::string& text) {
    ImGui::TextUnformatted(text.c_str());
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
/// Draws names over the picture; of names that overlap the nearest one.
void drawNames(std::span<const NameTag> names);
/// Shows at the lower edge that the use key moves the door in reach.
void drawDoor(const PanelFacts& facts);
/// Shows a line of text at the upper edge.
void drawNotice(const std::string& text);
/// Draws the panel with its two parts. `choice` holds the current values.
PanelChoice drawPanel(Ui& ui, const PanelFacts& facts, PanelChoice choice);
/// The part for players: time, weather, doors, quality, places, frame rate.
void drawPlayerPart(Ui& ui, const PanelFacts& facts, PanelChoice& choice);
/// The part for developers: visits, stages, residency, picking, checks.
void drawDeveloperPart(Ui& ui, const PanelFacts& facts);
/// Plots the frame times of the last seconds, with marks at 16.7 ms and 33.3 ms.
void drawFrameTimes(const TimeWindow& frame);

} // namespace limen::viewer::panel
