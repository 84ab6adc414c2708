#include "engine/DayGroup.h"
#include "viewer/panel/PanelParts.h"
#include "viewer/scale/ScaleControls.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

// The frame of the panel, and its part for players.
namespace limen::viewer::panel {
namespace {

/// A label at the left, the next control in the rest of the line.
void labelled(const char* label, const char* hint) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    uiHint(hint);
    ImGui::SameLine(uiLength(92.0f));
    ImGui::SetNextItemWidth(-1.0f);
}

void drawQuality(Ui& ui, PanelChoice& choice) {
    labelled("Quality", "Size of the loaded part of the world, sampling, and limits of the automatic scale.");
    const char* name = choice.quality ? engine::kQualities[*choice.quality].name : "custom";
    const bool isOpen = ImGui::BeginCombo("##quality", name);
    ui.note("panel quality");
    if (!isOpen)
        return;
    for (std::size_t i = 0; i < engine::kQualities.size(); ++i)
        if (ImGui::Selectable(engine::kQualities[i].name, choice.quality == i))
            choice.quality = i;
    ImGui::EndCombo();
}

void drawDay(const dat::SkyDesc& sky, PanelChoice& choice) {
    if (sky.dayGroups.size() < 2 || choice.dayGroup >= sky.dayGroups.size())
        return;
    labelled("Day", "The kinds of day that the world's Region describes: sky, light and fog.");
    if (!ImGui::BeginCombo("##day", engine::dayGroupLabel(sky, choice.dayGroup).c_str()))
        return;
    for (std::uint32_t group = 0; group < sky.dayGroups.size(); ++group) {
        ImGui::PushID(static_cast<int>(group));
        if (ImGui::Selectable(engine::dayGroupLabel(sky, group).c_str(), choice.dayGroup == group))
            choice.dayGroup = group;
        ImGui::PopID();
    }
    ImGui::EndCombo();
}

void drawTime(Ui& ui, const dat::GameTime& calendar, PanelChoice& choice) {
    labelled("Time", "Time of day. T advances it by one hour.");
    float hours = static_cast<float>(choice.time * 24.0);
    const int minutes = static_cast<int>(std::lround(choice.time * 24.0 * 60.0)) % (24 * 60);
    const std::string text =
        fmt::format("{:02}:{:02} {}", minutes / 60, minutes % 60, world::hourName(calendar, choice.time));
    if (ImGui::SliderFloat("##time", &hours, 0.0f, 24.0f, text.c_str()))
        choice.time = std::clamp(static_cast<double>(hours) / 24.0, 0.0, 1.0);
    ui.note("panel time");
}

void drawDoors(Ui& ui, PanelChoice& choice) {
    labelled("Doors", "Each door moves when you use it, or all doors share one position.");
    bool areAlike = choice.doors.has_value();
    if (ui.checkbox("all alike", areAlike))
        choice.doors = areAlike ? std::make_optional(choice.doors.value_or(0.0)) : std::nullopt;
    if (!choice.doors)
        return;
    labelled("", "");
    float open = static_cast<float>(100.0 * *choice.doors);
    if (ImGui::SliderFloat("##open", &open, 0.0f, 100.0f, "%.0f %% open"))
        choice.doors = std::clamp(static_cast<double>(open) / 100.0, 0.0, 1.0); // untouched doors keep theirs
    ui.note("panel doors");
}

void drawPlaceList(Ui& ui, std::span<const world::Place> places, PanelChoice& choice) {
    constexpr std::size_t kMost = 40; // the Places page has all, with a search
    if (places.empty())
        return;
    labelled("Place",
             "Go to a place. The keys 1 to 9 are the first nine; the menu has a list with a search.");
    const bool isOpen = ImGui::BeginCombo("##place", "go to...");
    ui.note("panel place");
    if (!isOpen)
        return;
    for (std::size_t i = 0; i < std::min(places.size(), kMost); ++i) {
        const std::string label =
            i < 9 ? fmt::format("{}   {}", i + 1, places[i].name) : fmt::format("     {}", places[i].name);
        if (ImGui::Selectable(label.c_str()))
            choice.place = static_cast<int>(i);
    }
    ImGui::EndCombo();
}

/// Draws a line across the plot at a frame time, with its text at the left or the right end.
void drawMark(double ms, double top, const char* text, bool isAtRight, const ImVec2& from, const ImVec2& to) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    const float y = to.y - static_cast<float>(ms / top) * (to.y - from.y);
    list->AddLine({from.x, y}, {to.x, y}, styleInk(StyleInk::Text, 0.6f));
    const float gap = uiLength(4.0f);
    const float x = isAtRight ? to.x - ImGui::CalcTextSize(text).x - gap : from.x + gap;
    list->AddText({x, std::max(y - ImGui::GetFontSize(), from.y)}, styleInk(StyleInk::Text), text);
}

} // namespace

void drawFrameTimes(const TimeWindow& frame) {
    if (frame.count() == 0)
        return;
    constexpr double kLeastTop = 40.0; // ms: both marks are visible on a fast machine
    const double top = std::max(1.25 * frame.p95(), kLeastTop);
    const auto value = [](void* window, int index) {
        return static_cast<float>(
            static_cast<const TimeWindow*>(window)->value(static_cast<std::size_t>(index)));
    };
    // ImGui passes the pointer back unchanged, but its parameter is not const.
    ImGui::PlotHistogram("##frames", value, const_cast<TimeWindow*>(&frame), static_cast<int>(frame.count()),
                         0, nullptr, 0.0f, static_cast<float>(top),
                         {ImGui::GetContentRegionAvail().x, uiLength(76.0f)});
    const ImVec2 pad = ImGui::GetStyle().FramePadding, from = ImGui::GetItemRectMin(),
                 to = ImGui::GetItemRectMax();
    const ImVec2 lower(from.x + pad.x, from.y + pad.y), upper(to.x - pad.x, to.y - pad.y);
    drawMark(1000.0 / 60.0, top, "16.7 ms", false, lower, upper);
    drawMark(1000.0 / 30.0, top, "33.3 ms", true, lower, upper);
    const double rate = 1e3 / std::max(frame.median(), 1e-3);
    line(fmt::format("{:.{}f} frames a second", rate, rate < 10.0 ? 1 : 0));
    uiNote(fmt::format("{:.1f} ms median, {:.1f} ms for the slowest twentieth", frame.median(), frame.p95()));
}

void drawPlayerPart(Ui& ui, const PanelFacts& facts, PanelChoice& choice) {
    drawTime(ui, facts.world.sky.time, choice);
    drawDay(facts.world.sky.desc, choice);
    labelled("Weather", "R switches the rain.");
    bool rain = choice.weather == engine::Weather::Rain;
    if (ui.checkbox("rain", rain))
        choice.weather = rain ? engine::Weather::Rain : engine::Weather::Clear;
    drawDoors(ui, choice);
    drawPlaceList(ui, facts.places, choice);
    drawQuality(ui, choice);
    labelled("Scale",
             "Size of the 3-D picture before it is enlarged to the window. The automatic scale keeps the "
             "frame rate.");
    chooseScale(ui, "panel scale", facts.scale, choice.scale);
    ImGui::Spacing();
    drawFrameTimes(facts.times.frame);
    uiNote(scaleText(facts.scale, facts.request.size));
}

PanelChoice drawPanel(Ui& ui, const PanelFacts& facts, PanelChoice choice) {
    const float margin = uiLength(10.0f);
    ImGui::SetNextWindowPos({margin, margin}, ImGuiCond_FirstUseEver);
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    const ImVec2 most{std::max(room.x - 2 * margin, 1.0f), std::max(room.y - 2 * margin, 1.0f)};
    const float width = std::min(uiLength(340.0f), most.x);
    ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {std::max(width, most.x * 0.6f), most.y});
    ImGui::SetNextWindowBgAlpha(0.95f);
    ImGui::Begin("##panel", nullptr,
                 ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoNav);
    if (ImGui::BeginTabBar("##parts")) {
        const bool isPlayer = ImGui::BeginTabItem("Player");
        ui.note("tab Player");
        if (isPlayer) {
            drawPlayerPart(ui, facts, choice);
            ImGui::EndTabItem();
        }
        const bool isDeveloper = ImGui::BeginTabItem("Developer");
        ui.note("tab Developer");
        if (isDeveloper) {
            drawDeveloperPart(ui, facts, choice);
            ImGui::EndTabItem();
        }
        ImGui::EndTabBar();
    }
    ImGui::End();
    return choice;
}

} // namespace limen::viewer::panel
