#pragma once

#include "viewer/pages/Pages.h"

#include <array>

namespace limen::viewer {

/// The page that opens a world: a directory field with completion and a list of directories, the recent
/// worlds, the directories of the game's installers, the built-in world.
class OpenPage {
public:
    /// `isNew`: the page was not shown in the last frame.
    [[nodiscard]] PageChoice draw(Ui& ui, const PagesFacts& facts, bool isNew);

private:
    void drawField(Ui& ui, PageChoice& choice, bool isNew);
    void drawBrowser(Ui& ui);
    void set(const std::string& text);

    std::array<char, 4096> text_{}; ///< as the user typed it
    std::string listed_;            ///< the text that `entries_` belongs to
    std::vector<std::string> entries_;
    bool isWorld_ = false;     ///< `listed_` looks like the directory of a world
    bool movesCursor_ = false; ///< give the field the focus, behind the new text
};

} // namespace limen::viewer
