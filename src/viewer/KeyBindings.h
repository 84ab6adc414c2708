#pragma once

#include "core/Error.h"
#include "viewer/KeyNames.h"

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

// Key bindings of the window. Independent of the window library: keys have their own numbers and names
// (KeyNames.h).
namespace limen::viewer {

/// Actions of keys. Forward to Sink act while the key is held; the others act once per press.
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
    Capture,
    Map,
    Photo,
    Search,
    Names,
    Menu,
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

/// When an action is available. One key can have one walking action and one flying action.
enum class When : std::uint8_t { Always, Walking, Flying };

struct ActionFacts {
    std::string_view name; ///< name in key files
    When when = When::Always;
    std::string_view does;                ///< description in the help
    std::array<std::string_view, 2> keys; ///< default keys; the second may be empty
};
[[nodiscard]] const ActionFacts& factsOf(Action action);
[[nodiscard]] std::optional<Action> actionNamed(std::string_view name);

/// The keys of each action, any number including none.
class KeyBindings {
public:
    KeyBindings(); ///< the default keys of ActionFacts

    [[nodiscard]] std::span<const KeyCode> keysOf(Action action) const& {
        return keys_[static_cast<std::size_t>(action)];
    }
    std::span<const KeyCode> keysOf(Action action) const&& = delete; ///< the span would dangle
    /// No action, one action, or one for walking and one for flying.
    [[nodiscard]] std::vector<Action> actionsOf(KeyCode key) const;

    /// Binds the key to the action. With `adds` the action keeps its other keys. The key loses actions that
    /// could be active at the same time. Requires a key with a name.
    void bind(Action action, KeyCode key, bool adds);
    /// Replaces the keys of the action, without a check for conflicts.
    void set(Action action, std::vector<KeyCode> keys) {
        keys_[static_cast<std::size_t>(action)] = std::move(keys);
    }

    friend bool operator==(const KeyBindings&, const KeyBindings&) = default;

private:
    std::array<std::vector<KeyCode>, kActions> keys_;
};

/// The keys of an action as text: "W or Up", or "no key".
[[nodiscard]] std::string keysText(const KeyBindings& bindings, Action action);

/// Parses a JSON object of actions, each with a key or a list of keys: {"forward": ["W", "Up"], "use": "F"}.
/// Other actions keep their default keys. `name` appears in messages. Errors name the entry: an unknown
/// action or key, a key with two actions at the same time.
[[nodiscard]] Result<KeyBindings> parseKeyBindings(const std::string& text, const std::string& name);

/// The JSON that parseKeyBindings reads, with the actions whose keys differ from the defaults.
[[nodiscard]] std::string keyBindingsJson(const KeyBindings& bindings);

/// $XDG_CONFIG_HOME/limen/keys.json, or ~/.config/limen/keys.json; empty if neither is known.
[[nodiscard]] std::filesystem::path keysPath();

/// Reads the file. If it is missing and `mustExist` is false, the default keys apply. Errors: as
/// parseKeyBindings; an unreadable file.
[[nodiscard]] Result<KeyBindings> readKeyBindings(const std::filesystem::path& file, bool mustExist);

/// Writes the file and creates its directory. Errors: an empty path; a file that cannot be written.
[[nodiscard]] Result<void> writeKeyBindings(const std::filesystem::path& file, const KeyBindings& bindings);

/// A line of the on-screen help.
struct HelpLine {
    std::string keys, does;
    std::optional<Action> action; ///< none: a mouse control
};
[[nodiscard]] std::vector<HelpLine> helpLines(const KeyBindings& bindings);
/// A button or stick of a gamepad, with its effect.
struct PadLine {
    std::string button, does;
};
[[nodiscard]] std::vector<PadLine> padLines();

} // namespace limen::viewer
