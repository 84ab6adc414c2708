#include "viewer/pages/Page.h"

#include "core/Assert.h"

#include <array>
#include <utility>

namespace limen::viewer {
namespace {

constexpr std::array<PageFacts, kPages> kPageFacts{{
    {.name = "world", .title = "", .needsWorld = true, .usesPointer = false},
    {.name = "menu", .title = "Limen", .pausesWorld = true},
    {.name = "open", .title = "Open a world", .pausesWorld = true, .isInMainMenu = true},
    {.name = "loading", .title = "Loading", .pausesWorld = true},
    {.name = "places", .title = "Places", .pausesWorld = true, .needsWorld = true, .isInMainMenu = true},
    {.name = "map", .title = "Map", .pausesWorld = true, .needsWorld = true, .isInMainMenu = true},
    {.name = "photo", .title = "Photo mode", .pausesWorld = true, .needsWorld = true, .isInMainMenu = true},
    {.name = "graphics", .title = "Graphics", .pausesWorld = true, .isInMainMenu = true},
    {.name = "controls", .title = "Controls", .pausesWorld = true, .isInMainMenu = true},
    {.name = "about", .title = "About", .pausesWorld = true, .isInMainMenu = true},
}};

/// The page that Escape leads to.
Page backFrom(const PageState& state) {
    switch (state.page) {
    case Page::World:
        return Page::Menu;
    case Page::Menu:
    case Page::Map:
    case Page::Photo:
        return state.hasWorld ? Page::World : Page::Menu;
    default:
        return state.hasWorld && state.isFromWorld ? Page::World : Page::Menu;
    }
}

bool isLoading(const PageState& state) {
    return !state.opening.empty();
}

PageState withoutLoading(PageState state, Page page) {
    state.opening.clear();
    state.page = page;
    return state;
}

} // namespace

const PageFacts& factsOf(Page page) {
    LIMEN_ASSERT(static_cast<std::size_t>(page) < kPages, "not a page");
    return kPageFacts[static_cast<std::size_t>(page)];
}

PageState after(PageState state, const PageEvent& event) {
    switch (event.kind) {
    case PageEvent::Kind::Back:
        if (isLoading(state)) // Escape cancels loading; the caller stops the work
            return withoutLoading(std::move(state), Page::Open);
        state.page = backFrom(state);
        return state;
    case PageEvent::Kind::Go:
        if (isLoading(state) || event.page == Page::Loading ||
            (factsOf(event.page).needsWorld && !state.hasWorld))
            return state;
        if (event.page != Page::Open)
            state.error.clear();
        state.isFromWorld = state.page == Page::World;
        state.page = event.page;
        return state;
    case PageEvent::Kind::Begin:
        state.page = Page::Loading;
        state.opening = event.text.empty() ? "a world" : event.text;
        state.error.clear();
        return state;
    case PageEvent::Kind::Loaded:
        if (!isLoading(state))
            return state;
        state.hasWorld = true;
        return withoutLoading(std::move(state), Page::World);
    case PageEvent::Kind::Failed:
        if (!isLoading(state))
            return state;
        state.error = event.text;
        return withoutLoading(std::move(state), Page::Open);
    case PageEvent::Kind::Cancelled:
        return isLoading(state) ? withoutLoading(std::move(state), Page::Open) : state;
    case PageEvent::Kind::Quit:
        state.quits = true;
        return state;
    }
    return state;
}

} // namespace limen::viewer
