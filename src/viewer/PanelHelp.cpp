#include "viewer/PanelParts.h"

// The help page.
namespace limen::viewer::panel {
namespace {

/// The button that changes an action's keys, and the one that adds one.
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
                                        {size.x * 0.98f, size.y * 0.98f}); // the rest is scrolled
    ImGui::Begin("Keys", nullptr,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoCollapse);
    line("A click on a key changes it: press the new one, or Escape. + adds one.");
    if (ImGui::SmallButton("all as at first"))
        choice.keysAsAtFirst = true;
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
    line("gamepad: left stick walks (all the way: runs), right looks, A jumps, X uses a door,\n"
         "Y the eye behind the body, B walk or fly, start this help, back the panel");
    ImGui::End();
}

} // namespace limen::viewer::panel
