#include "engine/map/PlacesOnMap.h"
#include "engine/placed/PlacedObjects.h"
#include "output/RegionOverlay.h"
#include "viewer/panel/PanelParts.h"

#include <algorithm>
#include <fmt/format.h>

// Drawings over the picture.
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
                      inkOf(colourOf(line.fate), isSeen ? 255 : 150), uiLength(isSeen ? 3.0f : 1.5f));
    }
}

/// Draws a line of text, centred horizontally, at a distance from the upper or the lower edge.
void drawBanner(const char* name, const std::string& text, bool isAtTop) {
    constexpr ImGuiWindowFlags kBare = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoInputs |
                                       ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    const float gap = uiLength(isAtTop ? 16.0f : 110.0f);
    ImGui::SetNextWindowPos({room.x * 0.5f, isAtTop ? gap : std::max(room.y - gap, room.y * 0.55f)},
                            ImGuiCond_Always, {0.5f, isAtTop ? 0.0f : 1.0f});
    ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {room.x - uiLength(24.0f), room.y});
    ImGui::SetNextWindowBgAlpha(0.78f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
    ImGui::Begin(name, nullptr, kBare);
    const float most = room.x - uiLength(60.0f);
    ImGui::PushTextWrapPos(ImGui::CalcTextSize(text.c_str()).x > most ? most : -1.0f);
    line(text);
    ImGui::PopTextWrapPos();
    ImGui::End();
    ImGui::PopStyleVar();
}

} // namespace

void drawLines(const PanelFacts& facts, const OverlaySwitches& switches) {
    if (switches.regions)
        drawRegionOutlines(facts.visible);
    drawPortals(facts);
    if (facts.frozen != nullptr)
        drawPyramids(*facts.frozen, facts.request);
}

void drawNames(std::span<const NameTag> names) {
    std::vector<engine::LabelBox> boxes;
    for (const NameTag& tag : names) {
        const ImVec2 at = screenPoint(tag.at), size = ImGui::CalcTextSize(tag.name.c_str());
        boxes.push_back({static_cast<double>(at.x - size.x / 2), static_cast<double>(at.y - size.y),
                         static_cast<double>(size.x), static_cast<double>(size.y)});
    }
    for (const std::size_t i : engine::labelsWithoutOverlap(boxes))
        uiOutlined(*ImGui::GetBackgroundDrawList(), static_cast<float>(boxes[i].x),
                   static_cast<float>(boxes[i].y), names[i].name.c_str());
}

void drawDoor(const PanelFacts& facts) {
    if (facts.door == nullptr)
        return;
    const bool isThing = facts.door->portal == world::kNone; // a chest or a lever has a name for people
    const std::string name = isThing ? engine::nameWithoutGuid(facts.door->name) : "the door";
    drawBanner("##door",
               facts.isRefused ? fmt::format("{} is locked", isThing ? name : "The door")
                               : fmt::format("{}   {} {}", keysText(facts.bindings, Action::Use),
                                             facts.doorOpens ? "close" : "open", name),
               false);
}

void drawNotice(const std::string& text) {
    if (!text.empty())
        drawBanner("##notice", text, true);
}

} // namespace limen::viewer::panel
