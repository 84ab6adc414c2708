#include "viewer/pages/Pages.h"

#include <array>
#include <fmt/format.h>
#include <imgui.h>

// The list of the world's places and, where there is a world.db, of its objects, with one search for both.
namespace limen::viewer {
namespace {

/// The search box. True: Enter was pressed in it, which chooses the first line.
bool drawSearch(Ui& ui, std::string& filter, PageChoice& choice) {
    std::array<char, 256> text{};
    filter.copy(text.data(), text.size() - 1);
    ImGui::SetNextItemWidth(-1.0f);
    if (ImGui::IsWindowAppearing()) {
        ImGui::SetKeyboardFocusHere();
        choice.searches = filter;
    }
    if (ImGui::InputTextWithHint("##filter", "search by name", text.data(), text.size())) {
        filter = text.data();
        choice.searches = filter;
    }
    ui.note("search");
    return ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter));
}

std::size_t drawFoundPlaces(Ui& ui, const PagesFacts& facts, const std::string& filter, bool takesFirst,
                            PageChoice& choice) {
    std::size_t shown = 0;
    for (std::size_t i = 0; i < facts.places.size(); ++i) {
        if (!containsText(facts.places[i].name, filter))
            continue;
        ImGui::PushID(static_cast<int>(i));
        if (ui.selectable(facts.places[i].name.c_str()) || (takesFirst && shown == 0)) {
            choice.place = i;
            choice.go(Page::World);
        }
        ImGui::PopID();
        ++shown;
    }
    return shown;
}

/// `takesFirst`: choose the first one, as if it had been clicked.
void drawFoundObjects(Ui& ui, const PagesFacts& facts, bool takesFirst, PageChoice& choice) {
    uiHeading("People and things");
    for (const engine::FoundObject& object : facts.objects) {
        ImGui::PushID(static_cast<int>(object.guid));
        const double away = glm::distance(Vec2(object.position), Vec2(facts.eye));
        const std::string label = fmt::format("{}   {}, {:.0f} m{}##object", object.name, object.type, away,
                                              object.cell != 0 ? ", indoors" : "");
        if (ui.selectable(label.c_str()) || std::exchange(takesFirst, false)) {
            choice.object = object.guid;
            choice.go(Page::World);
        }
        ImGui::PopID();
    }
}

} // namespace

PageChoice drawPlaces(Ui& ui, const PagesFacts& facts, std::string& filter) {
    PageChoice choice;
    constexpr PageBox kBox{.width = 520.0f, .height = 560.0f};
    beginPage(factsOf(Page::Places).title, kBox);
    const bool takesFirst = drawSearch(ui, filter, choice);
    ImGui::BeginChild("##list", {0.0f, uiListHeight()}, true);
    const std::size_t places = drawFoundPlaces(ui, facts, filter, takesFirst, choice);
    if (!facts.objects.empty())
        drawFoundObjects(ui, facts, takesFirst && places == 0, choice);
    else if (facts.hasObjects && filter.size() < kLeastSearched)
        uiNote("Type three letters of a name to find people and things.");
    else if (places == 0)
        uiNote(filter.empty() ? "This world names no places." : "Nothing has this name.");
    ImGui::EndChild();
    if (endPage(ui, kBox))
        choice.back();
    return choice;
}

} // namespace limen::viewer
