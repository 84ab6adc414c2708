#include "output/RegionOverlay.h"
#include "viewer/PanelParts.h"

#include <fmt/format.h>

// The panel's drawings over the picture.
namespace limen::viewer::panel {
namespace {

void drawRegionOutlines(const visibility::VisibleSet& visible) {
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    std::vector<ImVec2> points;
    for (std::uint32_t i = 0; i < visible.visits.size(); ++i) {
        points.clear();
        ImVec2 centre(0, 0);
        for (const Vec2& corner : engine::regionNdc(visible, visible.visits[i]))
            points.push_back(screenPoint(corner));
        if (points.empty())
            continue;
        for (const ImVec2& p : points) {
            centre.x += p.x / static_cast<float>(points.size());
            centre.y += p.y / static_cast<float>(points.size());
        }
        const output::Rgb rgb = output::distinctColour(i);
        const ImU32 colour = IM_COL32(rgb[0], rgb[1], rgb[2], 255);
        list->AddPolyline(points.data(), static_cast<int>(points.size()), colour, ImDrawFlags_Closed, 2.0f);
        list->AddText(centre, colour, fmt::format("{}", i).c_str());
    }
}

/// Draws the pyramids of a frozen flood.
void drawPyramids(const FrozenFlood& flood, const engine::FrameRequest& request) {
    constexpr double kShown = 6.0; // metres
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    for (const PyramidLine& line :
         pyramidLines(flood, engine::viewOf(request.camera, request.size, request.root), kShown)) {
        const output::Rgb rgb = output::distinctColour(line.visit);
        list->AddLine(screenPoint(line.from), screenPoint(line.to), IM_COL32(rgb[0], rgb[1], rgb[2], 200),
                      1.5f);
    }
}

/// Draws portal outlines through walls, coloured by fate.
void drawPortals(const PanelFacts& facts) {
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    const visibility::View view =
        engine::viewOf(facts.request.camera, facts.request.size, facts.request.root);
    for (const PortalLine& line : portalLines(facts.world, facts.portals, view)) {
        const bool isSeen = line.fate >= visibility::PortalFate::LeadsNowhere;
        list->AddLine(screenPoint(line.from), screenPoint(line.to),
                      inkOf(colourOf(line.fate), isSeen ? 255 : 150), scaled(isSeen ? 3.0f : 1.5f));
    }
}

constexpr ImGuiWindowFlags kBare = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoInputs |
                                   ImGuiWindowFlags_NoFocusOnAppearing;

/// Draws a line of text, centred horizontally, at a share of the window's height.
void drawBanner(const char* name, const std::string& text, float height, float pivot) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({size.x * 0.5f, size.y * height}, ImGuiCond_Always, {0.5f, pivot});
    ImGui::SetNextWindowBgAlpha(0.6f);
    ImGui::Begin(name, nullptr, kBare);
    line(text);
    ImGui::End();
}

/// Shows near the bottom edge that the use key opens or closes the door in reach.
void drawDoor(const PanelFacts& facts) {
    if (facts.door != nullptr)
        drawBanner("Door",
                   fmt::format("{}   {} the door", keysText(facts.bindings, Action::Use),
                               facts.doorOpens ? "close" : "open"),
                   0.96f, 1.0f);
}

} // namespace

void drawLines(const PanelFacts& facts, const OverlaySwitches& switches) {
    if (switches.regions)
        drawRegionOutlines(facts.visible);
    drawPortals(facts);
    if (facts.frozen != nullptr)
        drawPyramids(*facts.frozen, facts.request);
}

void drawBanners(const PanelFacts& facts, const OverlaySwitches& switches) {
    drawDoor(facts);
    if (!facts.notice.empty())
        drawBanner("Notice", std::string(facts.notice), 0.04f, 0.0f);
    if (facts.greets && !switches.help)
        drawBanner("Greeting", greeting(facts.bindings), 0.9f, 1.0f);
}

} // namespace limen::viewer::panel
