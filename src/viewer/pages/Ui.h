#pragma once

#include <string>
#include <string_view>
#include <vector>

struct ImDrawList;

// Controls of the pages and panels on Dear ImGui. Each control has a name in the state of `--tell`, so that
// tests find it on the screen. Call these functions inside a Dear ImGui frame only.
namespace limen::viewer {

/// A control that was drawn in a frame.
struct UiItem {
    std::string name;
    float x = 0.0f, y = 0.0f; ///< its centre, in screen units of the window
    bool isFocused = false;   ///< the keyboard or the gamepad has selected it
};

/// The controls of one frame, in the order of drawing.
class Ui {
public:
    void begin() { items_.clear(); }
    [[nodiscard]] const std::vector<UiItem>& items() const { return items_; }

    /// Records the control that was drawn last, if its centre is on the screen.
    void note(std::string_view name);
    /// A button. `width` 0: as wide as its label; below 0: the rest of the line.
    bool button(const char* label, float width = 0.0f);
    /// The main action of a page, in the accent colour.
    bool mainButton(const char* label, float width = 0.0f);
    bool checkbox(const char* label, bool& value);
    /// A line of a list that can be chosen.
    bool selectable(const char* label, bool isSelected = false);

private:
    std::vector<UiItem> items_;
};

/// Scales a length designed for letters of 16 units to the current font.
[[nodiscard]] float uiLength(float length);

/// Text as it is: no format characters.
void uiText(std::string_view text);
/// Secondary text, dimmed and wrapped at the window's edge.
void uiNote(std::string_view text);
/// Light text with a dark outline, over a picture. Screen units.
void uiOutlined(ImDrawList& list, float x, float y, const char* text);
/// The heading of a section.
void uiHeading(std::string_view text);
/// A tooltip for the control that was drawn last.
void uiHint(std::string_view text);

/// Whether a text contains another one. Letters of either case count as equal.
[[nodiscard]] bool containsText(std::string_view text, std::string_view part);

/// Darkens the world behind a page.
void dimPicture();

/// The size of a page's window.
struct PageBox {
    float width = 560.0f; ///< as for letters of 16 units
    float height = 0.0f;  ///< 0: as high as its content
    bool hasBack = true;  ///< draw a back button at the end
};
/// Begins a page: a window in the middle of the screen that fits every window size and scrolls if it must.
/// Always call endPage afterwards. `title` as PageFacts::title.
void beginPage(std::string_view title, const PageBox& box = {});
/// The height of a list above the back button of a page: the rest of the page, but at least two rows.
[[nodiscard]] float uiListHeight();
/// Ends a page. True: the user chose Back.
bool endPage(Ui& ui, const PageBox& box = {});

} // namespace limen::viewer
