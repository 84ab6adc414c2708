#include "viewer/PanelParts.h"

// The help page.
namespace limen::viewer::panel {
namespace {

/// Draws two buttons: one replaces an action's keys, the other adds a key.
void drawKeyButtons(const PanelFacts& facts, const HelpLine& help, PanelChoice& choice) {
    const Action action = *help.action;
    ImGui::PushID(static_cast<int>(action));
    const bool waits = facts.rebinding && facts.rebinding->action == action;
    const std::string label = (waits ? "press a key" : help.keys) + "###keys";
    if (ImGui::SmallButton(label.c_str()))
        choice.rebinding = Rebinding{action, false};
    ImGui::SameLine();
    if (ImGui::SmallButton("+"))
        choice.rebinding = Rebinding{action, true};
    ImGui::PopID();
}

} // namespace

void drawHelp(const PanelFacts& facts, PanelChoice& choice) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({size.x * 0.5f, size.y * 0.5f}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f},
                                        {size.x * 0.98f, size.y * 0.98f}); // longer content scrolls
    ImGui::Begin("Keys", nullptr,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoCollapse);
    line("To change a key, click it and press the new key (Escape cancels). To add a key, click +.");
    if (ImGui::SmallButton("reset to defaults"))
        choice.resetsKeys = true;
    if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
        for (const HelpLine& help : helpLines(facts.bindings)) {
            ImGui::TableNextColumn();
            if (help.action)
                drawKeyButtons(facts, help, choice);
            else
                line(help.keys);
            ImGui::TableNextColumn();
            line(help.does);
        }
        ImGui::EndTable();
    }
    line("gamepad: left stick walk (full deflection: run), right stick look, A jump, X use a door,\n"
         "Y third person / first person, B walk / fly, start this help, back panel");
    ImGui::End();
}

} // namespace limen::viewer::panel
