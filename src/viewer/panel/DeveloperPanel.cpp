#include "engine/report/VisitTree.h"
#include "viewer/panel/PanelParts.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

// The part of the panel for developers, section by section.
namespace limen::viewer::panel {
namespace {

/// Median and p95, or a dash.
std::string windowText(const TimeWindow& window) {
    return window.count() == 0 ? std::string("-")
                               : fmt::format("{:.3f} {:.3f}", window.median(), window.p95());
}

void drawStages(const PanelFacts& facts) {
    if (!ImGui::BeginTable("stages", 4, ImGuiTableFlags_BordersInnerH))
        return;
    for (const char* heading : {"stage", "draws", "CPU ms, p95", "GPU ms, p95"})
        ImGui::TableSetupColumn(heading);
    ImGui::TableHeadersRow();
    const std::vector<engine::StageFigures>& stages = facts.figures.stages;
    for (std::size_t i = 0; i < stages.size() && i < facts.times.stages.size(); ++i) {
        const StageWindows& times = facts.times.stages[i];
        for (const std::string& text : {stages[i].name, fmt::format("{}", stages[i].draws),
                                        windowText(times.cpu), windowText(times.gpu)}) {
            ImGui::TableNextColumn();
            line(text);
        }
    }
    ImGui::EndTable();
}

/// The state of movement: flying, or the body's space and footing.
std::string footingOf(const PanelFacts& facts) {
    if (facts.body == nullptr)
        return "flying";
    return fmt::format("body in {}, {}{}", engine::spaceName(facts.world, facts.body->standing.space),
                       facts.body->isOnGround ? "on the ground" : "in the air",
                       facts.body->recoveries > 0
                           ? fmt::format(", fell out of the world {} times", facts.body->recoveries)
                           : "");
}

void drawFigures(const PanelFacts& facts) {
    const engine::Camera& camera = facts.request.camera;
    if (!ImGui::CollapsingHeader("Frame", ImGuiTreeNodeFlags_DefaultOpen))
        return;
    line(fmt::format("root {}", engine::spaceName(facts.world, facts.request.root)));
    uiHint("The space that contains the eye. The flood of visibility starts here.");
    line(footingOf(facts));
    line(fmt::format("eye {:.2f} {:.2f} {:.2f}", camera.eye.x, camera.eye.y, camera.eye.z));
    line(fmt::format("yaw {:.1f} pitch {:.1f}", camera.heading.yaw, camera.heading.pitch));
    line(fmt::format("{} visits, {} cells seen", facts.visible.visits.size(),
                     engine::cellsSeen(facts.world, facts.visible).size()));
    uiHint("A visit is a space seen through one chain of portals. A cell can be visited several times.");
    if (facts.visible.counts.visitsCut > 0)
        line(fmt::format("{} visits LEFT OUT: budget", facts.visible.counts.visitsCut));
    line(fmt::format("{} drawn, {} culled, {} triangles", facts.plan.counts.instancesDrawn,
                     facts.plan.counts.instancesCulled, facts.plan.counts.triangles));
    uiHint("Instances inside and outside of the frustums of their visits, and triangles sent to the graphics "
           "card.");
    line(fmt::format("flood {:.3f} ms, plan {:.3f} ms, {} GL calls", facts.figures.floodMs,
                     facts.figures.planMs, facts.figures.glCalls));
    uiHint("Processor time of visibility and of the draw plan, and calls of the driver in this frame.");
    const gpu::DeviceObjects& resident = facts.figures.resident;
    line(fmt::format("{} textures, {} handles, {:.0f} MiB of buffers", resident.textures,
                     resident.residentHandles, static_cast<double>(resident.bufferBytes) / (1 << 20)));
    line(fmt::format("ring {:.1f} MiB, {} stalls, {:.1f} KiB this frame",
                     static_cast<double>(resident.ringBytes) / (1 << 20), facts.figures.ringStalls,
                     static_cast<double>(facts.figures.bytesWritten) / 1024.0));
    uiHint("Memory for the data of each frame; a stall is a wait for the graphics card.");
    if (!facts.figures.trouble.empty())
        line("culling disabled after a driver fault: " + facts.figures.trouble);
    drawStages(facts);
}

/// The gate that draws the frame, and for other gates than Gate::Ownership the spaces in drawing order.
void drawGate(Ui& ui, const PanelFacts& facts, PanelChoice& choice) {
    if (!ImGui::CollapsingHeader("Gate", ImGuiTreeNodeFlags_DefaultOpen))
        return;
    uiHint("The way to keep each space within its openings: docs/gates.md.");
    for (const frame::Gate gate : frame::kGates) {
        if (gate != frame::kGates.front())
            ImGui::SameLine();
        if (ImGui::RadioButton(std::string(nameOf(gate)).c_str(), choice.gate == gate))
            choice.gate = gate;
        ui.note(fmt::format("panel gate {}", nameOf(gate)));
    }
    for (const frame::GatedSpace& gated : facts.plan.spaces)
        line(fmt::format("{}: {} regions, {} planes{}", engine::spaceName(facts.world, gated.space),
                         gated.regions, gated.planes,
                         gated.fallbacks > 0 ? fmt::format(", {} rectangles", gated.fallbacks) : ""));
}

/// Draws a visit and its descendants. Returns the first visit after them. `hovered` is set to the visit under
/// the mouse.
std::uint32_t drawVisit(const PanelFacts& facts, std::uint32_t visit, bool isShown, int& hovered) {
    bool isOpen = false;
    if (isShown) {
        // The visit's number identifies the node, because the rest of the label changes from frame to frame.
        isOpen = ImGui::TreeNodeEx(reinterpret_cast<const void*>(std::uintptr_t{visit}),
                                   ImGuiTreeNodeFlags_DefaultOpen, "%s",
                                   engine::visitLabel(facts.world, facts.visible, visit).c_str());
        if (ImGui::IsItemHovered())
            hovered = static_cast<int>(visit);
    }
    if (isOpen) {
        const std::vector<std::string> besides = engine::seenBesides(facts.world, facts.visible, visit);
        if (!besides.empty())
            ImGui::TextDisabled("%s", fmt::format("and {}", fmt::join(besides, ", ")).c_str());
    }
    std::uint32_t next = visit + 1;
    const std::vector<visibility::Visit>& visits = facts.visible.visits;
    while (next < visits.size() && visits[next].depth > visits[visit].depth) // depth-first
        next = drawVisit(facts, next, isOpen, hovered);
    if (isOpen)
        ImGui::TreePop();
    return next;
}

/// Draws the tree of visits: the reason why each room is drawn. Fills the region of the visit under the
/// mouse.
void drawVisits(const PanelFacts& facts) {
    if (facts.visible.visits.empty() || !ImGui::CollapsingHeader("Visits", ImGuiTreeNodeFlags_DefaultOpen))
        return;
    uiHint("The tree of portals by which each space is seen. Point at a visit to see its region.");
    int hovered = -1;
    drawVisit(facts, 0, true, hovered);
    if (hovered < 0)
        return;
    std::vector<ImVec2> points;
    for (const Vec2& corner :
         engine::regionNdc(facts.visible, facts.visible.visits[static_cast<std::size_t>(hovered)]))
        points.push_back(screenPoint(corner));
    if (points.size() > 2)
        ImGui::GetBackgroundDrawList()->AddConvexPolyFilled(points.data(), static_cast<int>(points.size()),
                                                            IM_COL32(255, 220, 80, 90));
}

/// Lists the number of portals of each fate, admitted first, with the portals below.
void drawPortalList(const PanelFacts& facts) {
    if (facts.portals.empty() || !ImGui::CollapsingHeader("Portals", ImGuiTreeNodeFlags_DefaultOpen))
        return;
    const auto counts = countFates(facts.portals);
    for (std::size_t i = counts.size(); i-- > 0;) {
        const auto fate = static_cast<visibility::PortalFate>(i);
        if (counts[i] == 0)
            continue;
        ImGui::PushStyleColor(ImGuiCol_Text, inkOf(colourOf(fate), 255));
        const bool isOpen =
            ImGui::TreeNode(nameOf(fate).data(), "%s", fmt::format("{} {}", counts[i], nameOf(fate)).c_str());
        ImGui::PopStyleColor();
        if (!isOpen)
            continue;
        for (const PortalTrace& trace : facts.portals)
            if (trace.fate == fate)
                line(portalLabel(facts.world, trace));
        ImGui::TreePop();
    }
}

/// Draws the tooltip of the landblock under the mouse.
void drawBlockHint(const ResidentBlock& block) {
    ImGui::BeginTooltip();
    line(fmt::format("{:02X}{:02X}{}{}", block.coord.x & 0xFF, block.coord.y & 0xFF,
                     block.holdsEye ? ", contains the eye" : "",
                     block.holdsPlayer ? ", contains the player" : ""));
    if (block.state == ResidentBlock::State::Absent)
        line("not loaded");
    else
        line(fmt::format("{}, {} cells, {} building portals", block.hasTerrain ? "terrain" : "no terrain",
                         block.cells, block.buildingPortals));
    ImGui::EndTooltip();
}

ImU32 blockInk(const ResidentBlock& block) {
    if (block.state == ResidentBlock::State::Absent)
        return IM_COL32(50, 50, 50, 255);
    if (block.cells == 0)
        return block.hasTerrain ? IM_COL32(60, 110, 60, 255) : IM_COL32(90, 90, 60, 255);
    return block.hasTerrain ? IM_COL32(120, 190, 90, 255) : IM_COL32(110, 130, 210, 255);
}

/// Draws a map of the landblocks around the eye, north up, with eye and player.
void drawResidency(const ResidencyMap& map) {
    if (!ImGui::CollapsingHeader("Residency"))
        return;
    line(fmt::format("{} blocks, {} with terrain, {} cells, {} building portals", map.loaded, map.terrains,
                     map.cells, map.buildingPortals));
    const float size = uiLength(16.0f), gap = uiLength(2.0f);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImDrawList* list = ImGui::GetWindowDrawList();
    for (int i = 0; i < map.side * map.side; ++i) {
        const ResidentBlock& block = map.blocks[static_cast<std::size_t>(i)];
        const ImVec2 from(corner.x + static_cast<float>(i % map.side) * size,
                          corner.y + static_cast<float>(i / map.side) * size);
        const ImVec2 to(from.x + size - gap, from.y + size - gap);
        list->AddRectFilled(from, to, blockInk(block));
        if (block.holdsEye)
            list->AddRect(from, to, IM_COL32(255, 255, 255, 255), 0.0f, 0, gap);
        if (block.holdsPlayer)
            list->AddCircleFilled({(from.x + to.x) * 0.5f, (from.y + to.y) * 0.5f}, size * 0.2f,
                                  IM_COL32(255, 220, 80, 255));
        if (ImGui::IsMouseHoveringRect(from, to))
            drawBlockHint(block);
    }
    const float side = static_cast<float>(map.side) * size;
    ImGui::Dummy({side, side});
    ImGui::TextDisabled(
        "%s", "green: terrain; bright green: terrain and cells; blue: cells only;\nframe: eye; dot: player");
}

void drawPicked(const engine::Picked* picked) {
    if (picked == nullptr || !ImGui::CollapsingHeader("Picked", ImGuiTreeNodeFlags_DefaultOpen))
        return;
    for (const std::string& text : engine::pickedLines(*picked))
        line(text);
}

/// Lists the number of pixels of each verdict.
void drawVerdict(const ViewVerdict* verdict) {
    if (verdict == nullptr || !ImGui::CollapsingHeader("Checked", ImGuiTreeNodeFlags_DefaultOpen))
        return;
    const check::Comparison& comparison = verdict->comparison;
    line(fmt::format("{} wrong of {} pixels, {:.1f} s", comparison.findings(), comparison.verdicts.size(),
                     verdict->seconds));
    for (std::size_t i = 1; i < check::kVerdictCount; ++i) // verdict 0 is agreement
        if (comparison.counts[i] > 0)
            line(fmt::format("{} {}", comparison.counts[i], check::kVerdictNames[i]));
}

/// Lists faults of the data.
void drawFindings(std::span<const world::Finding> findings) {
    constexpr std::size_t kMost = 20;
    const std::string title = fmt::format("Warnings ({})###warnings", findings.size());
    if (findings.empty() || !ImGui::CollapsingHeader(title.c_str()))
        return;
    for (const world::Finding& finding : findings.first(std::min(findings.size(), kMost)))
        line(fmt::format("{} {}", dat::idText(finding.record), finding.what));
    if (findings.size() > kMost)
        line(fmt::format("and {} more", findings.size() - kMost));
}

/// Lists the decisions that depend on the driver; the reason of each is its tooltip.
void drawDriver(Ui& ui, const PanelFacts& facts) {
    const bool isOpen = ImGui::CollapsingHeader("Driver");
    ui.note("section Driver");
    if (!isOpen)
        return;
    uiNote(facts.figures.driver);
    if (!facts.figures.choices || !ImGui::BeginTable("choices", 2, ImGuiTableFlags_SizingFixedFit))
        return;
    for (const gpu::DriverChoice& choice : gpu::describe(*facts.figures.choices)) {
        std::string name = choice.name;
        std::replace(name.begin(), name.end(), '_', ' ');
        ImGui::TableNextColumn();
        line(name);
        uiHint(choice.reason);
        ImGui::TableNextColumn();
        line(choice.value);
        uiHint(choice.reason);
    }
    ImGui::EndTable();
}

} // namespace

void drawDeveloperPart(Ui& ui, const PanelFacts& facts, PanelChoice& choice) {
    drawFigures(facts);
    drawGate(ui, facts, choice);
    drawVerdict(facts.verdict);
    drawPicked(facts.picked);
    drawVisits(facts);
    drawPortalList(facts);
    drawResidency(facts.residency);
    drawFindings(facts.world.findings);
    drawDriver(ui, facts);
}

} // namespace limen::viewer::panel
