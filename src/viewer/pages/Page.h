#pragma once

#include <cstdint>
#include <string>
#include <string_view>

// The page of the window and the events that change it. Independent of drawing and of the window library.
namespace limen::viewer {

/// The pages of the window. World and Photo show the world alone; the others cover it.
enum class Page : std::uint8_t { World, Menu, Open, Loading, Places, Map, Photo, Graphics, Controls, About };
inline constexpr std::size_t kPages = static_cast<std::size_t>(Page::About) + 1;

struct PageFacts {
    std::string_view name;     ///< in the state of `--tell`
    std::string_view title;    ///< heading of the page
    bool pausesWorld = false;  ///< the world's time stops, and keys and mouse do not move the player
    bool needsWorld = false;   ///< only available while a world is shown
    bool usesPointer = true;   ///< controls are drawn: the mouse is released
    bool isInMainMenu = false; ///< the main menu has an entry for it
};
[[nodiscard]] const PageFacts& factsOf(Page page);

/// The page on the screen.
struct PageState {
    Page page = Page::Open;
    bool hasWorld = false;    ///< a world is drawn behind the page
    std::string opening;      ///< the world that is loading, as the user named it; empty: none
    std::string error;        ///< the reason why the last world did not open; shown on the Open page
    bool isFromWorld = false; ///< the page was opened from the world: Back leads there
    bool quits = false;
    friend bool operator==(const PageState&, const PageState&) = default;
};

struct PageEvent {
    enum class Kind : std::uint8_t {
        Back,      ///< Escape, or B on a gamepad
        Go,        ///< to `page`
        Begin,     ///< a world begins to load; `text`: its name
        Loaded,    ///< that world is shown
        Failed,    ///< that world did not open; `text`: the reason
        Cancelled, ///< the user cancelled loading
        Quit
    };
    Kind kind = Kind::Back;
    Page page = Page::World; ///< of Go
    std::string text;
};

/// The state after an event. Events that do not fit the state change nothing: a page that needs a world
/// without one, the result of a load that was cancelled.
[[nodiscard]] PageState after(PageState state, const PageEvent& event);

} // namespace limen::viewer
