#include "viewer/Style.h"
#include "viewer/pages/Pages.h"

#include <fmt/format.h>
#include <imgui.h>

namespace limen::viewer {
namespace {

void drawMenuEntry(Ui& ui, Page page, const PageState& state, PageChoice& choice) {
    const PageFacts& facts = factsOf(page);
    if (!facts.isInMainMenu)
        return;
    ImGui::BeginDisabled(facts.needsWorld && !state.hasWorld);
    if (ui.button(facts.title.data(), -1.0f))
        choice.go(page);
    ImGui::EndDisabled();
}

} // namespace

PageChoice drawMenu(Ui& ui, const PagesFacts& facts) {
    PageChoice choice;
    constexpr PageBox kBox{.width = 320.0f, .hasBack = false};
    const bool isTight = ImGui::GetIO().DisplaySize.y < uiLength(430.0f); // all entries fit into 360 units
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {uiLength(8.0f), uiLength(isTight ? 3.0f : 8.0f)});
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {uiLength(10.0f), uiLength(isTight ? 3.0f : 6.0f)});
    beginPage(factsOf(Page::Menu).title, kBox);
    uiNote(facts.worldName.empty() ? std::string("no world is open") : facts.worldName);
    ImGui::Spacing();
    if (facts.state.hasWorld) {
        if (ui.mainButton("Resume", -1.0f))
            choice.go(Page::World);
        ImGui::SetItemDefaultFocus();
    }
    for (std::size_t i = 0; i < kPages; ++i) {
        drawMenuEntry(ui, static_cast<Page>(i), facts.state, choice);
        if (static_cast<Page>(i) == Page::Open) {
            if (ui.button("Built-in world", -1.0f))
                choice.opens = std::string();
            uiHint("Open the world that comes with the program. It needs no files of the game.");
        }
    }
    ImGui::Spacing();
    if (ui.button("Quit", -1.0f))
        choice.event = PageEvent{PageEvent::Kind::Quit, Page::World, {}};
    static_cast<void>(endPage(ui, kBox));
    ImGui::PopStyleVar(2);
    return choice;
}

PageChoice drawLoading(Ui& ui, const PagesFacts& facts) {
    PageChoice choice;
    constexpr PageBox kBox{.width = 520.0f, .hasBack = false};
    const LoadingFacts& loading = facts.loading;
    beginPage(factsOf(Page::Loading).title, kBox);
    uiText(facts.state.opening);
    ImGui::Spacing();
    const auto share = [](std::size_t done, std::size_t all) {
        return all > 0 ? static_cast<float>(done) / static_cast<float>(all) : 0.0f;
    };
    const bool searches = loading.blocks == 0 && loading.toSearch > 0;
    const float read = share(loading.blocksRead, loading.blocks);
    ImGui::ProgressBar(searches ? share(loading.searched, loading.toSearch)
                                : 0.7f * read + 0.3f * static_cast<float>(loading.uploaded),
                       {-1.0f, 0.0f}, "");
    uiText(loading.step);
    if (searches)
        uiNote(fmt::format("{} of {} towns and dungeons searched", loading.searched, loading.toSearch));
    else if (loading.blocks > 0)
        uiNote(fmt::format("{} of {} landblocks read, {:.0f} % uploaded to the graphics card",
                           loading.blocksRead, loading.blocks, 100.0 * loading.uploaded));
    else
        uiNote("counting landblocks");
    ImGui::Spacing();
    if (ui.button("Cancel", uiLength(120.0f)))
        choice.event = PageEvent{PageEvent::Kind::Cancelled, Page::World, {}};
    static_cast<void>(endPage(ui, kBox));
    return choice;
}

PageChoice drawAbout(Ui& ui, const PagesFacts& facts) {
    PageChoice choice;
    beginPage(factsOf(Page::About).title);
    uiText(fmt::format("Limen {}", facts.version));
    uiNote("Draws worlds of interiors and landscape joined by portals: the built-in world, or the files of "
           "Asheron's Call that you own.");
    uiHeading("Graphics driver");
    uiText(facts.driver.empty() ? std::string("known when a world is open") : facts.driver);
    uiHeading("Font");
    uiText(facts.fontNote);
    uiHeading("Rights");
    uiNote("Limen contains no data of the game. Asheron's Call is a trademark of its owners, who have no "
           "part in this program.");
    if (endPage(ui))
        choice.back();
    return choice;
}

} // namespace limen::viewer
