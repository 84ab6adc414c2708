#include "viewer/pages/HintBar.h"

#include "viewer/Style.h"
#include "viewer/pages/Ui.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace limen::viewer {
namespace {

std::string firstKey(const KeyBindings& bindings, Action action) {
    const auto keys = bindings.keysOf(action);
    return keys.empty() ? std::string("no key") : std::string(nameOf(keys.front()));
}

float widthOf(const Hint& hint) {
    return ImGui::CalcTextSize(hint.keys.c_str()).x + ImGui::CalcTextSize(hint.does.c_str()).x +
           uiLength(42.0f);
}

/// Draws one key cap and its effect at the cursor.
void drawHint(const Hint& hint, float opacity) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size = ImGui::CalcTextSize(hint.keys.c_str());
    const float pad = uiLength(6.0f), high = uiLength(2.0f);
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled({corner.x, corner.y - high}, {corner.x + size.x + 2 * pad, corner.y + size.y + high},
                        styleInk(StyleInk::KeyCap, opacity), uiLength(4.0f));
    list->AddText({corner.x + pad, corner.y}, styleInk(StyleInk::Text, opacity), hint.keys.c_str());
    list->AddText({corner.x + size.x + 2 * pad + uiLength(8.0f), corner.y}, styleInk(StyleInk::Text, opacity),
                  hint.does.c_str());
    ImGui::Dummy({widthOf(hint), size.y + uiLength(6.0f)});
}

} // namespace

double hintOpacity(double seconds) {
    return std::clamp((kHintSeconds - seconds) / kHintFade, 0.0, 1.0);
}

std::vector<Hint> hints(const KeyBindings& bindings, bool capturesMouse) {
    const auto key = [&](Action action) { return firstKey(bindings, action); };
    return {{fmt::format("{} {} {} {}", key(Action::Forward), key(Action::Left), key(Action::Back),
                         key(Action::Right)),
             "walk"},
            {capturesMouse ? "Click" : "Drag", "look around"},
            {key(Action::Use), "open a door"},
            {key(Action::Chase), "third person"},
            {key(Action::Help), "all keys"},
            {key(Action::Menu), "menu"}};
}

void drawHintBar(const std::vector<Hint>& hints, double opacity) {
    if (opacity <= 0.0)
        return;
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    const float most = room.x - uiLength(48.0f);
    float whole = 0.0f, used = 0.0f;
    for (const Hint& hint : hints)
        whole += widthOf(hint);
    ImGui::SetNextWindowPos({room.x * 0.5f, room.y - uiLength(16.0f)}, ImGuiCond_Always, {0.5f, 1.0f});
    ImGui::SetNextWindowBgAlpha(0.72f * static_cast<float>(opacity));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {uiLength(16.0f), uiLength(10.0f)});
    ImGui::Begin("##hints", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
    // Lines of about equal length instead of one full line and a short rest.
    const float lines = std::ceil(whole / most), goal = whole / lines + uiLength(30.0f);
    for (const Hint& hint : hints) {
        const float width = widthOf(hint);
        if (used > 0.0f && used + width <= goal)
            ImGui::SameLine(0.0f, 0.0f);
        else
            used = 0.0f;
        drawHint(hint, static_cast<float>(opacity));
        used += width;
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
}

} // namespace limen::viewer
