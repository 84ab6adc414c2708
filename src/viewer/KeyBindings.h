#pragma once

#include "core/Error.h"
#include "viewer/KeyNames.h"

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

// Which keys do what in the window. Knows nothing of windows: keys have numbers and names of their own (KeyNames.h).
namespace limen::viewer {

/// What keys do. The first few as long as they are held down, the others once when pressed.
enum class Action : std::uint8_t {
    Forward,
    Back,
    Left,
    Right,
    Run,
    Jump,
    Rise,
    Sink,
    Use,
    Walk,
    Chase,
    Doors,
    Rain,
    Later,
    Help,
    Ids,
    Regions,
    Panel,
    Check,
    Probe,
    Freeze,
    Portals,
    Depth,
    FullScreen,
    Screenshot,
    Leave,
    Place1,
    Place2,
    Place3,
    Place4,
    Place5,
    Place6,
    Place7,
    Place8,
    Place9
};
inline constexpr std::size_t kActions = static_cast<std::size_t>(Action::Place9) + 1;

/// When an action can be done. A key may serve one action of those who walk and one of those who fly.
enum class When : std::uint8_t { Always, Walking, Flying };

struct ActionFacts {
    std::string_view name; ///< in files
    When when = When::Always;
    std::string_view does; ///< for people
    std::array<std::string_view, 2>
        keys; ///< that do it unless a file says otherwise; the second may be empty
};
[[nodiscard]] const ActionFacts& factsOf(Action action);
[[nodiscard]] std::optional<Action> actionNamed(std::string_view name);

/// Keys by action: any number each, none included.
class KeyBindings {
public:
    KeyBindings(); ///< as ActionFacts say

    [[nodiscard]] std::span<const KeyCode> keysOf(Action action) const& {
        return keys_[static_cast<std::size_t>(action)];
    }
    std::span<const KeyCode> keysOf(Action action) const&& = delete; ///< they would be gone
    /// One, or two of which one is for walking and the other for flying; none.
    [[nodiscard]] std::vector<Action> actionsOf(KeyCode key) const;

    /// From now on the key does this: it alone, or with `adds` besides those that did. What it did at the same times it does no
    /// longer. Requires a key with a name.
    void bind(Action action, KeyCode key, bool adds);
    /// These keys and no others, whatever else they do.
    void set(Action action, std::vector<KeyCode> keys) {
        keys_[static_cast<std::size_t>(action)] = std::move(keys);
    }

    friend bool operator==(const KeyBindings&, const KeyBindings&) = default;

private:
    std::array<std::vector<KeyCode>, kActions> keys_;
};

/// The keys of an action in words: "W or Up"; "no key".
[[nodiscard]] std::string keysText(const KeyBindings& bindings, Action action);

/// From a JSON object of actions, each with a key or a list of them: {"forward": ["W", "Up"], "use": "F"}. Actions that are not in it
/// keep their keys. `name` is for messages. Errors, each with the entry: no such action; no such key; a key that does two things.
[[nodiscard]] Result<KeyBindings> parseKeyBindings(const std::string& text, const std::string& name);

/// What parseKeyBindings reads them from: the actions whose keys are others than at first.
[[nodiscard]] std::string keyBindingsJson(const KeyBindings& bindings);

/// $XDG_CONFIG_HOME/limen/keys.json, or ~/.config/limen/keys.json; empty if neither is known.
[[nodiscard]] std::filesystem::path keysPath();

/// Of the file; `mustExist` false: without one as at first. Errors: as parseKeyBindings'; it cannot be read.
[[nodiscard]] Result<KeyBindings> readKeyBindings(const std::filesystem::path& file, bool mustExist);

/// Writes them to the file; its directory is made. Errors: it cannot be written; an empty path.
[[nodiscard]] Result<void> writeKeyBindings(const std::filesystem::path& file, const KeyBindings& bindings);

/// A line of the on-screen help.
struct HelpLine {
    std::string keys, does;
    std::optional<Action> action; ///< none: of several actions
};
[[nodiscard]] std::vector<HelpLine> helpLines(const KeyBindings& bindings);
/// In one line what somebody has to know who has just opened the window.
[[nodiscard]] std::string greeting(const KeyBindings& bindings);

} // namespace limen::viewer
