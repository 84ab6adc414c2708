#pragma once

#include "viewer/KeyBindings.h"
#include "viewer/pages/Page.h"
#include "viewer/settings/Settings.h"

#include <optional>
#include <string>

namespace limen::viewer {

/// A pending key binding: the next key replaces the keys of the action, or is added to them.
struct Rebinding {
    Action action = Action::Forward;
    bool adds = false;
    friend bool operator==(const Rebinding&, const Rebinding&) = default;
};

/// A choice of the user on a page. All pages return it; the application carries it out.
struct PageChoice {
    std::optional<PageEvent> event;
    std::optional<std::string> opens;    ///< the directory of a world to open; empty text: the built-in world
    std::optional<std::size_t> place;    ///< index of the world's places
    std::optional<std::string> searches; ///< search placed objects for this text
    std::optional<std::uint32_t> object; ///< go before this placed object: its guid
    std::optional<Settings> settings;    ///< changed settings; their `uiScale` is unchanged
    std::optional<ScaleWish> scale;
    std::optional<double> uiScale; ///< a new size of letters, in place of the command line's, too
    std::optional<Rebinding> rebinding;
    bool resetsKeys = false;

    void go(Page page) { event = PageEvent{PageEvent::Kind::Go, page, {}}; }
    void back() { event = PageEvent{PageEvent::Kind::Back, Page::World, {}}; }
};

} // namespace limen::viewer
