#include "viewer/pages/Ui.h"

#include "viewer/Style.h"

#include <algorithm>
#include <cctype>
#include <imgui.h>

namespace limen::viewer {
namespace {

constexpr ImGuiWindowFlags kPageFlags = ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse |
                                        ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                        ImGuiWindowFlags_NoTitleBar;

void pushAccent() {
    const ImVec4 accent = ImGui::GetStyleColorVec4(ImGuiCol_CheckMark);
    const auto shade = [&](float factor) {
        return ImVec4(accent.x * factor, accent.y * factor, accent.z * factor, 1.0f);
    };
    ImGui::PushStyleColor(ImGuiCol_Button, shade(0.92f));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, shade(1.0f));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, shade(0.8f));
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0.07f, 0.07f, 0.06f, 1.0f));
}

} // namespace

void Ui::note(std::string_view name) {
    const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
    const ImVec2 centre((from.x + to.x) * 0.5f, (from.y + to.y) * 0.5f);
    const ImVec2 low = ImGui::GetWindowDrawList()->GetClipRectMin(),
                 high = ImGui::GetWindowDrawList()->GetClipRectMax();
    constexpr float kEdge = 3.0f; // units; a centre this close to the edge cannot be clicked
    if (centre.x < low.x + kEdge || centre.y < low.y + kEdge || centre.x > high.x - kEdge ||
        centre.y > high.y - kEdge)
        return;
    const std::string_view shown = name.starts_with("##") ? name.substr(2) : name.substr(0, name.find("##"));
    items_.push_back({std::string(shown), centre.x, centre.y, ImGui::IsItemFocused()});
}

bool Ui::button(const char* label, float width) {
    const bool isPressed = ImGui::Button(label, {width, 0.0f});
    note(label);
    return isPressed;
}

bool Ui::mainButton(const char* label, float width) {
    pushAccent();
    const bool isPressed = button(label, width);
    ImGui::PopStyleColor(4);
    return isPressed;
}

bool Ui::checkbox(const char* label, bool& value) {
    const bool isChanged = ImGui::Checkbox(label, &value);
    note(label);
    return isChanged;
}

bool Ui::selectable(const char* label, bool isSelected) {
    const bool isPressed = ImGui::Selectable(label, isSelected);
    note(label);
    return isPressed;
}

float uiLength(float length) {
    return length * ImGui::GetFontSize() / kLetterSize;
}

void uiText(std::string_view text) {
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
}

void uiNote(std::string_view text) {
    ImGui::PushStyleColor(ImGuiCol_Text, styleInk(StyleInk::Dim));
    uiText(text);
    ImGui::PopStyleColor();
}

void uiOutlined(ImDrawList& list, float x, float y, const char* text) {
    constexpr ImU32 kInk = IM_COL32(255, 255, 255, 255), kOutline = IM_COL32(0, 0, 0, 200);
    for (const ImVec2& by : {ImVec2(-1, 0), ImVec2(1, 0), ImVec2(0, -1), ImVec2(0, 1)})
        list.AddText({x + by.x, y + by.y}, kOutline, text);
    list.AddText({x, y}, kInk, text);
}

void uiHeading(std::string_view text) {
    ImGui::Spacing();
    ImGui::PushStyleColor(ImGuiCol_Text, styleInk(StyleInk::Accent));
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopStyleColor();
}

void uiHint(std::string_view text) {
    if (!ImGui::IsItemHovered())
        return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(uiLength(340.0f));
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool containsText(std::string_view text, std::string_view part) {
    const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    return std::search(text.begin(), text.end(), part.begin(), part.end(),
                       [&](char a, char b) { return lower(a) == lower(b); }) != text.end() ||
           part.empty();
}

void dimPicture() {
    ImGui::GetBackgroundDrawList()->AddRectFilled({0.0f, 0.0f}, ImGui::GetIO().DisplaySize,
                                                  styleInk(StyleInk::Backdrop, 0.45f));
}

void beginPage(std::string_view title, const PageBox& box) {
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    const float margin = uiLength(12.0f);
    const ImVec2 most{std::max(room.x - 2 * margin, 1.0f), std::max(room.y - 2 * margin, 1.0f)};
    const float width = std::min(uiLength(box.width), most.x);
    ImGui::SetNextWindowPos({room.x * 0.5f, room.y * 0.5f}, ImGuiCond_Always, {0.5f, 0.5f});
    if (box.height > 0.0f)
        ImGui::SetNextWindowSize({width, std::min(uiLength(box.height), most.y)}, ImGuiCond_Always);
    else
        ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, most.y});
    const std::string name = std::string("##page ") + std::string(title);
    ImGui::Begin(name.c_str(), nullptr,
                 kPageFlags | (box.height > 0.0f ? 0 : ImGuiWindowFlags_AlwaysAutoResize));
    constexpr float kLow = 260.0f; // a page with a list leaves out its title in such a height
    if (box.height > 0.0f && most.y < uiLength(kLow))
        return;
    ImGui::SetWindowFontScale(1.35f);
    ImGui::TextUnformatted(title.data(), title.data() + title.size());
    ImGui::SetWindowFontScale(1.0f);
    ImGui::Separator();
    ImGui::Spacing();
}

float uiListHeight() {
    return std::max(ImGui::GetContentRegionAvail().y - uiLength(60.0f), 2.0f * ImGui::GetFrameHeight());
}

bool endPage(Ui& ui, const PageBox& box) {
    bool goesBack = false;
    if (box.hasBack) {
        ImGui::Spacing();
        ImGui::Separator();
        ImGui::Spacing();
        goesBack = ui.button("Back", uiLength(120.0f));
    }
    ImGui::End();
    return goesBack;
}

} // namespace limen::viewer
