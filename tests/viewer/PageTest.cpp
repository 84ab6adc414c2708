#include "viewer/pages/Page.h"
#include "viewer/pages/HintBar.h"

#include <gtest/gtest.h>

namespace limen::viewer {
namespace {

using On = PageEvent::Kind;

PageState inWorld() {
    PageState state;
    state = after(state, {On::Begin, Page::Loading, "somewhere"});
    return after(state, {On::Loaded, Page::World, {}});
}

TEST(Page, escapeOpensTheMenuAndClosesIt) {
    PageState state = inWorld();
    EXPECT_EQ(state.page, Page::World);
    state = after(state, {});
    EXPECT_EQ(state.page, Page::Menu);
    state = after(state, {});
    EXPECT_EQ(state.page, Page::World);
    EXPECT_FALSE(state.quits);
}

TEST(Page, backLeadsWhereThePageWasOpened) {
    PageState fromWorld = after(inWorld(), {On::Go, Page::Controls, {}});
    EXPECT_EQ(after(fromWorld, {}).page, Page::World);
    PageState fromMenu = after(after(inWorld(), {}), {On::Go, Page::Controls, {}});
    EXPECT_EQ(after(fromMenu, {}).page, Page::Menu);
}

TEST(Page, withoutAWorldThereIsNoWayIntoIt) {
    PageState state;
    for (const Page page : {Page::World, Page::Places, Page::Map, Page::Photo})
        EXPECT_EQ(after(state, {On::Go, page, {}}), state);
    state = after(state, {On::Go, Page::Menu, {}});
    EXPECT_EQ(after(state, {}).page, Page::Menu); // Escape cannot close it
}

TEST(Page, aWorldThatFailsToOpenLeadsBackWithTheReason) {
    PageState state = after(inWorld(), {On::Begin, Page::Loading, "/bad"});
    EXPECT_EQ(state.page, Page::Loading);
    state = after(state, {On::Failed, Page::Open, "no such directory"});
    EXPECT_EQ(state.page, Page::Open);
    EXPECT_EQ(state.error, "no such directory");
    EXPECT_TRUE(state.hasWorld); // the old world stays
    state = after(state, {On::Begin, Page::Loading, "/good"});
    EXPECT_EQ(state.error, "");
}

TEST(Page, aResultAfterACancelChangesNothing) {
    for (const PageEvent& cancel : {PageEvent{}, PageEvent{On::Cancelled, Page::World, {}}}) {
        PageState state = after(PageState{}, {On::Begin, Page::Loading, "/slow"});
        EXPECT_EQ(after(state, {On::Go, Page::Menu, {}}), state); // no way past a world that loads
        state = after(state, cancel);
        EXPECT_EQ(state.page, Page::Open);
        EXPECT_EQ(after(state, {On::Loaded, Page::World, {}}), state);
        EXPECT_EQ(after(state, {On::Failed, Page::World, "late"}), state);
    }
}

TEST(Page, eachHasANameOfItsOwn) {
    for (std::size_t i = 0; i < kPages; ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_NE(factsOf(static_cast<Page>(i)).name, factsOf(static_cast<Page>(j)).name);
}

TEST(HintBar, isShownForTenSecondsAndFades) {
    EXPECT_EQ(hintOpacity(0.0), 1.0);
    EXPECT_EQ(hintOpacity(kHintSeconds - kHintFade), 1.0);
    EXPECT_DOUBLE_EQ(hintOpacity(kHintSeconds - kHintFade / 2), 0.5);
    EXPECT_EQ(hintOpacity(kHintSeconds), 0.0);
    EXPECT_EQ(hintOpacity(1e9), 0.0);
}

TEST(HintBar, namesTheKeysOfTheUser) {
    KeyBindings bindings;
    bindings.bind(Action::Use, *keyNamed("F"), false);
    const std::vector<Hint> shown = hints(bindings, true);
    EXPECT_EQ(shown[0].keys, "W A S D");
    EXPECT_EQ(shown[1].keys, "Click");
    EXPECT_EQ(shown[2].keys, "F");
    EXPECT_EQ(hints(bindings, false)[1].keys, "Drag");
}

} // namespace
} // namespace limen::viewer
