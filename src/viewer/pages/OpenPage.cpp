#include "viewer/pages/OpenPage.h"

#include "core/platform/Environment.h"
#include "viewer/Style.h"
#include "viewer/open/PathCompletion.h"

#include <algorithm>
#include <cstring>
#include <imgui.h>

namespace limen::viewer {
namespace {

std::string homeDirectory() {
    return platform::homeDirectory().generic_string();
}

/// Completes the text at the cursor when Tab is pressed.
int completeText(ImGuiInputTextCallbackData* data) {
    if (data->EventFlag != ImGuiInputTextFlags_CallbackCompletion)
        return 0;
    const PathCompletion completion = completeDirectory(
        std::string(data->Buf, static_cast<std::size_t>(data->BufTextLen)), homeDirectory());
    data->DeleteChars(0, data->BufTextLen);
    data->InsertChars(0, completion.text.c_str());
    return 0;
}

void drawError(const std::string& error) {
    if (error.empty())
        return;
    ImGui::PushStyleColor(ImGuiCol_Text, styleInk(StyleInk::Bad));
    uiText(error);
    ImGui::PopStyleColor();
    ImGui::Spacing();
}

/// A list of directories to open with one click.
void drawDirectories(Ui& ui, const char* heading, const std::vector<std::string>& directories,
                     PageChoice& choice) {
    if (directories.empty())
        return;
    uiHeading(heading);
    ImGui::PushID(heading);
    for (const std::string& directory : directories)
        if (ui.selectable(directory.empty() ? "the built-in world" : directory.c_str()))
            choice.opens = directory;
    ImGui::PopID();
}

} // namespace

void OpenPage::set(const std::string& text) {
    text_.fill(0);
    text.copy(text_.data(), text_.size() - 1);
    movesCursor_ = true;
}

void OpenPage::drawField(Ui& ui, PageChoice& choice, bool isNew) {
    constexpr float kButton = 96.0f;
    if (isNew || movesCursor_)
        ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-uiLength(kButton) - ImGui::GetStyle().ItemSpacing.x);
    const ImGuiInputTextFlags flags =
        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackCompletion;
    const bool isEntered = ImGui::InputTextWithHint("##directory", "directory of the game's files",
                                                    text_.data(), text_.size(), flags, completeText);
    ui.note("directory");
    movesCursor_ = false;
    ImGui::SameLine();
    const bool isPressed = ui.mainButton("Open", uiLength(kButton));
    const std::string directory = expandHome(text_.data(), homeDirectory());
    if ((isEntered || isPressed) && !directory.empty())
        choice.opens = directory;
}

void OpenPage::drawBrowser(Ui& ui) {
    const std::string home = homeDirectory(), typed = text_.data();
    if (typed != listed_) {
        listed_ = typed;
        entries_ = completeDirectory(typed, home).matches;
        isWorld_ = looksLikeWorld(expandHome(typed, home));
    }
    if (isWorld_)
        uiNote("This directory holds a client_portal.dat. Press Open.");
    ImGui::BeginChild("##browser", {0.0f, uiLength(132.0f)}, true);
    if (!expandHome(typed, home).empty() && ui.selectable("\xE2\x86\x91 up"))
        set(parentOf(typed, home));
    for (const std::string& entry : entries_) {
        const std::string name = entry.substr(entry.rfind('/') + 1) + "/";
        if (ui.selectable(name.c_str()))
            set(entry + "/");
    }
    if (entries_.empty() && !isWorld_)
        uiNote("no directory here begins with this text");
    ImGui::EndChild();
}

PageChoice OpenPage::draw(Ui& ui, const PagesFacts& facts, bool isNew) {
    PageChoice choice;
    constexpr PageBox kBox{.width = 680.0f};
    if (isNew && text_[0] == '\0') {
        const auto typed = std::find_if(facts.settings.recent.begin(), facts.settings.recent.end(),
                                        [](const std::string& recent) { return !recent.empty(); });
        set(typed != facts.settings.recent.end() ? *typed : homeDirectory() + "/");
    }
    beginPage(factsOf(Page::Open).title, kBox);
    drawError(facts.state.error);
    uiText("Directory of the game's files");
    uiNote("It holds client_portal.dat and client_cell_1.dat. Tab completes the name. You can also drop the "
           "directory onto this window.");
    drawField(ui, choice, isNew);
    drawBrowser(ui);
    std::vector<std::string> found;
    for (const std::filesystem::path& directory : facts.gameDirectories)
        found.push_back(directory.string());
    drawDirectories(ui, "Found on this computer", found, choice);
    drawDirectories(ui, "Recent", facts.settings.recent, choice);
    ImGui::Spacing();
    if (ui.button("Open the built-in world"))
        choice.opens = std::string();
    if (endPage(ui, kBox))
        choice.back();
    return choice;
}

} // namespace limen::viewer
