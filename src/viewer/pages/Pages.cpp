#include "viewer/pages/Pages.h"

#include "viewer/pages/OpenPage.h"

namespace limen::viewer {

Pages::Pages() : open_(std::make_unique<OpenPage>()) {}
Pages::~Pages() = default;

PageChoice Pages::draw(Ui& ui, const PagesFacts& facts) {
    const Page page = facts.state.page;
    if (page != last_)
        placesFilter_.clear();
    const bool isNew = last_ != page;
    last_ = page;
    switch (page) {
    case Page::World:
        return {};
    case Page::Menu:
        return drawMenu(ui, facts);
    case Page::Open:
        return open_->draw(ui, facts, isNew);
    case Page::Loading:
        return drawLoading(ui, facts);
    case Page::Places:
        return drawPlaces(ui, facts, placesFilter_);
    case Page::Map:   // drawn by MapPage
    case Page::Photo: // drawn by PhotoPage
        return {};
    case Page::Graphics:
        return drawGraphics(ui, facts, draggedUiScale_);
    case Page::Controls:
        return drawControls(ui, facts);
    case Page::About:
        return drawAbout(ui, facts);
    }
    return {};
}

} // namespace limen::viewer
