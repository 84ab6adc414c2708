#include "engine/Quality.h"
#include "viewer/pages/Pages.h"
#include "viewer/scale/ScaleControls.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <utility>

// The pages of settings: graphics, and controls with the key bindings.
namespace limen::viewer {
namespace {

void beginSettings(const char* name) {
    ImGui::BeginTable(name, 2, ImGuiTableFlags_SizingStretchProp);
    ImGui::TableSetupColumn("##label", ImGuiTableColumnFlags_WidthStretch, 0.38f);
    ImGui::TableSetupColumn("##value", ImGuiTableColumnFlags_WidthStretch, 0.62f);
}

void beginSetting(const char* label, const char* hint) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    uiHint(hint);
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(-1.0f);
}

bool slide(Ui& ui, const char* name, double& value, double least, double most, const char* format) {
    float number = static_cast<float>(value);
    const std::string id = std::string("##") + name;
    const bool isChanged = ImGui::SliderFloat(id.c_str(), &number, static_cast<float>(least),
                                              static_cast<float>(most), format, ImGuiSliderFlags_AlwaysClamp);
    ui.note(name);
    if (isChanged)
        value = std::round(static_cast<double>(number) * 100.0) / 100.0;
    return isChanged;
}

std::string qualityText(const engine::Quality& quality) {
    return fmt::format("{}: buildings within {} blocks, ground within {}", quality.name, quality.radius,
                       quality.farRadius);
}

void chooseQuality(Ui& ui, Settings& settings) {
    const auto quality = engine::qualityNamed(settings.quality);
    const std::string shown = quality ? qualityText(engine::kQualities[*quality]) : "standard";
    const bool isOpen = ImGui::BeginCombo("##quality", shown.c_str());
    ui.note("quality");
    if (!isOpen)
        return;
    for (const engine::Quality& other : engine::kQualities)
        if (ui.selectable(qualityText(other).c_str(), settings.quality == other.name))
            settings.quality = other.name;
    ImGui::EndCombo();
}

void chooseLook(Ui& ui, Settings& settings) {
    const auto textOf = [](world::Look look) {
        return look == world::Look::Retail
                   ? "retail: as the original drew"
                   : "enhanced: light per pixel, smooth animations, grain on the ground";
    };
    const bool isOpen = ImGui::BeginCombo("##look", textOf(settings.look));
    ui.note("look");
    if (!isOpen)
        return;
    for (const world::Look look : {world::Look::Retail, world::Look::Enhanced})
        if (ui.selectable(textOf(look), settings.look == look))
            settings.look = look;
    ImGui::EndCombo();
}

/// Draws two buttons: one replaces an action's keys, the other adds a key.
void drawKeyButtons(Ui& ui, const PagesFacts& facts, const HelpLine& help, PageChoice& choice) {
    const Action action = *help.action;
    const std::string name(factsOf(action).name);
    ImGui::PushID(static_cast<int>(action));
    const bool waits = facts.rebinding && facts.rebinding->action == action;
    const std::string label = (waits ? "press a key" : help.keys) + "###keys";
    if (ImGui::SmallButton(label.c_str()))
        choice.rebinding = Rebinding{action, false};
    ui.note("key " + name);
    ImGui::SameLine();
    if (ImGui::SmallButton("+"))
        choice.rebinding = Rebinding{action, true};
    ui.note("add key " + name);
    ImGui::PopID();
}

void drawKeys(Ui& ui, const PagesFacts& facts, PageChoice& choice) {
    if (!ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingStretchProp))
        return;
    ImGui::TableSetupColumn("##keys", ImGuiTableColumnFlags_WidthStretch, 0.42f);
    ImGui::TableSetupColumn("##does", ImGuiTableColumnFlags_WidthStretch, 0.58f);
    for (const HelpLine& help : helpLines(facts.bindings)) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        if (help.action)
            drawKeyButtons(ui, facts, help, choice);
        else
            uiText(help.keys);
        ImGui::TableNextColumn();
        uiText(help.does);
    }
    ImGui::EndTable();
}

void drawGamepad(bool isThere) {
    uiNote(isThere ? "A gamepad is connected." : "No gamepad is connected.");
    if (!ImGui::BeginTable("pad", 2, ImGuiTableFlags_SizingStretchProp))
        return;
    ImGui::TableSetupColumn("##button", ImGuiTableColumnFlags_WidthStretch, 0.42f);
    ImGui::TableSetupColumn("##does", ImGuiTableColumnFlags_WidthStretch, 0.58f);
    for (const PadLine& line : padLines()) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        uiText(line.button);
        ImGui::TableNextColumn();
        uiText(line.does);
    }
    ImGui::EndTable();
}

} // namespace

PageChoice drawGraphics(Ui& ui, const PagesFacts& facts, std::optional<double>& dragged) {
    PageChoice choice;
    Settings settings = facts.settings;
    beginPage(factsOf(Page::Graphics).title);
    beginSettings("graphics");
    beginSetting("Quality", "Size of the loaded part of the world, sampling, and limits of the automatic "
                            "scale. All levels draw the same "
                            "surfaces; they differ in distance and smoothness.");
    chooseQuality(ui, settings);
    beginSetting("Look",
                 "Both show the same surfaces. They differ in lamps on walls, in animations and in the "
                 "grain of the ground.");
    chooseLook(ui, settings);
    ScaleWish scale = facts.scale.wish;
    beginSetting("Scale",
                 "Size of the 3-D picture before it is enlarged to the window. Letters and controls always "
                 "have full size.");
    chooseScale(ui, "scale", facts.scale, scale);
    beginSetting("Frame rate", "The automatic scale makes the 3-D picture smaller to keep this rate.");
    chooseFrameRate(ui, "frame rate", facts.scale, scale);
    beginSetting("Field of view", "Vertical angle of the picture.");
    slide(ui, "field of view", settings.fieldOfView, 30.0, 110.0, "%.0f degrees");
    beginSetting("Size of letters", "On top of the scale of your screen.");
    // The page changes its size only when the slider is let go: it would slip from under the pointer.
    double uiScale = dragged.value_or(facts.uiScale);
    if (slide(ui, "ui scale", uiScale, 0.5, 4.0, "%.2f"))
        dragged = uiScale;
    if (dragged && !ImGui::IsItemActive())
        choice.uiScale = std::exchange(dragged, std::nullopt);
    beginSetting("Full screen", "The key F11 switches, too.");
    ui.checkbox("##full screen", settings.isFullScreen);
    ImGui::EndTable();
    if (endPage(ui))
        choice.back();
    if (settings != facts.settings)
        choice.settings = std::move(settings);
    if (scale != facts.scale.wish)
        choice.scale = scale;
    return choice;
}

PageChoice drawControls(Ui& ui, const PagesFacts& facts) {
    PageChoice choice;
    Settings settings = facts.settings;
    constexpr PageBox kBox{.width = 640.0f, .height = 640.0f};
    beginPage(factsOf(Page::Controls).title, kBox);
    ImGui::BeginChild("##controls", {0.0f, uiListHeight()});
    uiHeading("Mouse");
    beginSettings("mouse");
    beginSetting("Look around", "Capture: a click captures the mouse, Tab releases it. Drag: hold a button "
                                "and move the mouse.");
    bool captures = settings.mouse == MouseMode::Capture;
    if (ui.checkbox("a click captures the mouse", captures))
        settings.mouse = captures ? MouseMode::Capture : MouseMode::Drag;
    beginSetting("Speed", "Factor on the turn of the view.");
    slide(ui, "mouse speed", settings.sensitivity, 0.1, 5.0, "%.2f");
    beginSetting("Invert", "Applies to the mouse and to the right stick.");
    ui.checkbox("push away to look down", settings.invertY);
    ImGui::EndTable();
    uiHeading("Keys");
    uiNote("Click a key and press the new one; Escape cancels. + adds a key.");
    if (ui.button("Reset keys to defaults"))
        choice.resetsKeys = true;
    drawKeys(ui, facts, choice);
    uiHeading("Gamepad");
    drawGamepad(facts.hasGamepad);
    ImGui::EndChild();
    if (endPage(ui, kBox))
        choice.back();
    if (settings != facts.settings)
        choice.settings = std::move(settings);
    return choice;
}

} // namespace limen::viewer
