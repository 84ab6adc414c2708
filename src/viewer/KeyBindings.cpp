#include "viewer/KeyBindings.h"

#include "core/Assert.h"
#include "engine/UserFiles.h"
#include "output/OutputFile.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace limen::viewer {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::array<ActionFacts, kActions> kFacts{{
    {"forward", When::Always, "move forward", {"W", "Up"}},
    {"back", When::Always, "move back", {"S", "Down"}},
    {"left", When::Always, "move left", {"A", "Left"}},
    {"right", When::Always, "move right", {"D", "Right"}},
    {"run", When::Always, "run, or fly fast", {"LeftShift", "RightShift"}},
    {"jump", When::Walking, "jump", {"Space", ""}},
    {"rise", When::Flying, "rise (when flying)", {"E", "Space"}},
    {"sink", When::Flying, "sink (when flying)", {"Q", "LeftControl"}},
    {"use", When::Walking, "open or close the door in front of you", {"E", ""}},
    {"walk", When::Always, "switch between walking and flying", {"G", ""}},
    {"chase", When::Always, "third person / first person", {"C", ""}},
    {"doors", When::Always, "open or close all doors", {"O", ""}},
    {"rain", When::Always, "toggle rain", {"R", ""}},
    {"later", When::Always, "advance the time by one hour", {"T", ""}},
    {"help", When::Always, "show or hide this help", {"F1", ""}},
    {"ids", When::Always, "show ids as colours", {"F2", ""}},
    {"regions", When::Always, "show the regions of visits", {"F3", ""}},
    {"panel", When::Always, "show or hide the panel", {"F4", ""}},
    {"check", When::Always, "check this view against traced rays", {"F5", ""}},
    {"probe", When::Always, "log changes between frames to standard output", {"F6", ""}},
    {"freeze", When::Always, "freeze visibility", {"F7", ""}},
    {"portals", When::Always, "show portals and the fate of rays at each", {"F8", ""}},
    {"depth", When::Always, "show depth as grey levels", {"F9", ""}},
    {"gate", When::Always, "draw with the next gate: ownership, planes, depth", {"F10", ""}},
    {"full_screen", When::Always, "toggle full screen", {"F11", ""}},
    {"screenshot", When::Always, "save a screenshot", {"F12", ""}},
    {"capture", When::Always, "capture or release the mouse", {"Tab", ""}},
    {"map", When::Always, "show the map", {"M", ""}},
    {"photo", When::Always, "photo mode", {"P", ""}},
    {"search", When::Always, "search places, people and things by name", {"/", "F"}},
    {"names", When::Always, "show or hide the names of people and things", {"N", ""}},
    {"leave", When::Always, "menu (quit is there)", {"Escape", ""}},
    {"place_1", When::Always, "go to the first place", {"1", ""}},
    {"place_2", When::Always, "go to the second place", {"2", ""}},
    {"place_3", When::Always, "go to the third place", {"3", ""}},
    {"place_4", When::Always, "go to the fourth place", {"4", ""}},
    {"place_5", When::Always, "go to the fifth place", {"5", ""}},
    {"place_6", When::Always, "go to the sixth place", {"6", ""}},
    {"place_7", When::Always, "go to the seventh place", {"7", ""}},
    {"place_8", When::Always, "go to the eighth place", {"8", ""}},
    {"place_9", When::Always, "go to the ninth place", {"9", ""}},
}};

constexpr bool areKeysKnown() {
    for (const ActionFacts& facts : kFacts)
        if (!keyNamed(facts.keys[0]) || (!facts.keys[1].empty() && !keyNamed(facts.keys[1])))
            return false;
    return true;
}
static_assert(areKeysKnown());

constexpr Action actionAt(std::size_t index) {
    return static_cast<Action>(index);
}

bool meet(When a, When b) {
    return a == When::Always || b == When::Always || a == b;
}

bool has(std::span<const KeyCode> keys, KeyCode key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// Another action of the key that can be active at the same time as this one.
std::optional<Action> rivalOf(const KeyBindings& bindings, Action action, KeyCode key) {
    for (const Action other : bindings.actionsOf(key))
        if (other != action && meet(factsOf(other).when, factsOf(action).when))
            return other;
    return std::nullopt;
}

/// Reads one entry of a file: a key name or a list of key names.
Result<std::vector<KeyCode>> keysIn(const Json& json, const std::string& where) {
    const Json list = json.is_array() ? json : Json::array({json});
    std::vector<KeyCode> keys;
    for (const Json& item : list) {
        if (!item.is_string())
            return fail(ErrorCode::Malformed, where,
                        R"(is neither a key name nor a list of key names, such as "F" or ["W", "Up"])");
        const std::string& name = item.get_ref<const std::string&>();
        const std::optional<KeyCode> key = keyNamed(name);
        if (!key)
            return fail(ErrorCode::Malformed, where,
                        fmt::format("unknown key '{}'; use a name such as F, Escape or LeftShift", name));
        if (!has(keys, *key))
            keys.push_back(*key);
    }
    return keys;
}

/// Actions that were added after the first key files. Keys of a file win over their default keys.
constexpr std::array kNewActions{Action::Capture, Action::Map, Action::Photo};

void freeNewKeys(KeyBindings& bindings, const std::vector<KeyCode>& taken, const Json& json) {
    for (const Action action : kNewActions) {
        if (json.contains(factsOf(action).name))
            continue;
        const std::span<const KeyCode> before = bindings.keysOf(action);
        std::vector<KeyCode> keys(before.begin(), before.end());
        std::erase_if(keys, [&](KeyCode key) { return has(taken, key); });
        bindings.set(action, std::move(keys));
    }
}

/// Errors: a key with two actions at the same time.
Result<void> checkRivals(const KeyBindings& bindings, const std::string& name, const Json& json) {
    for (std::size_t i = 0; i < kActions; ++i) {
        const Action action = actionAt(i);
        if (!json.contains(factsOf(action).name))
            continue; // the error names the action that took its key
        for (const KeyCode key : bindings.keysOf(action)) {
            if (const std::optional<Action> rival = rivalOf(bindings, action, key))
                return fail(ErrorCode::Malformed, fmt::format("{}, {}", name, factsOf(action).name),
                            fmt::format("{} is already the key of {}; give one of them another key",
                                        nameOf(key), factsOf(*rival).name));
        }
    }
    return {};
}

} // namespace

const ActionFacts& factsOf(Action action) {
    LIMEN_ASSERT(static_cast<std::size_t>(action) < kActions, "not an action");
    return kFacts[static_cast<std::size_t>(action)];
}

std::optional<Action> actionNamed(std::string_view name) {
    const auto found =
        std::find_if(kFacts.begin(), kFacts.end(), [&](const auto& facts) { return facts.name == name; });
    return found == kFacts.end()
               ? std::nullopt
               : std::make_optional(actionAt(static_cast<std::size_t>(found - kFacts.begin())));
}

KeyBindings::KeyBindings() {
    for (std::size_t i = 0; i < kActions; ++i) {
        for (const std::string_view name : kFacts[i].keys)
            if (!name.empty())
                keys_[i].push_back(*keyNamed(name));
    }
}

std::vector<Action> KeyBindings::actionsOf(KeyCode key) const {
    std::vector<Action> actions;
    for (std::size_t i = 0; i < kActions; ++i)
        if (has(keys_[i], key))
            actions.push_back(actionAt(i));
    return actions;
}

void KeyBindings::bind(Action action, KeyCode key, bool adds) {
    LIMEN_ASSERT(!nameOf(key).empty(), "a key without a name cannot be written to a file");
    while (const std::optional<Action> rival = rivalOf(*this, action, key)) {
        std::vector<KeyCode>& keys = keys_[static_cast<std::size_t>(*rival)];
        keys.erase(std::find(keys.begin(), keys.end(), key));
    }
    if (!adds)
        keys_[static_cast<std::size_t>(action)].clear();
    if (!has(keysOf(action), key))
        keys_[static_cast<std::size_t>(action)].push_back(key);
}

std::string keysText(const KeyBindings& bindings, Action action) {
    std::vector<std::string_view> names;
    for (const KeyCode key : bindings.keysOf(action))
        names.push_back(nameOf(key));
    return names.empty() ? "no key" : fmt::format("{}", fmt::join(names, " or "));
}

Result<KeyBindings> parseKeyBindings(const std::string& text, const std::string& name) {
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object())
        return fail(ErrorCode::Malformed, name,
                    R"(is not a JSON object of actions and keys, such as {"use": "F"})");
    KeyBindings bindings;
    std::vector<std::pair<Action, std::vector<KeyCode>>> entries;
    for (const auto& [entry, value] : json.items()) {
        const std::string where = fmt::format("{}, {}", name, entry);
        const std::optional<Action> action = actionNamed(entry);
        if (!action)
            return fail(ErrorCode::Malformed, where, "unknown action; limen view --help lists the actions");
        Result<std::vector<KeyCode>> keys = keysIn(value, where);
        if (!keys)
            return Failure(keys.error());
        entries.emplace_back(*action, std::move(*keys));
    }
    for (const auto& [action, keys] : entries) {
        freeNewKeys(bindings, keys, json);
        bindings.set(action, keys);
    }
    if (Result<void> checked = checkRivals(bindings, name, json); !checked)
        return Failure(checked.error());
    return bindings;
}

std::string keyBindingsJson(const KeyBindings& bindings) {
    Json json = Json::object();
    const KeyBindings first;
    for (std::size_t i = 0; i < kActions; ++i) {
        const std::span<const KeyCode> keys = bindings.keysOf(actionAt(i)),
                                       before = first.keysOf(actionAt(i));
        if (std::equal(keys.begin(), keys.end(), before.begin(), before.end()))
            continue;
        Json names = Json::array();
        for (const KeyCode key : keys)
            names.push_back(nameOf(key));
        json[std::string(kFacts[i].name)] = std::move(names);
    }
    return json.dump(1) + "\n";
}

fs::path keysPath() {
    const fs::path root = engine::configurationRoot();
    return root.empty() ? fs::path() : root / "keys.json";
}

Result<KeyBindings> readKeyBindings(const fs::path& file, bool mustExist) {
    constexpr std::size_t kLongest = 1u << 20; // bytes
    std::error_code error;
    if (!mustExist && (file.empty() || !fs::exists(file, error)))
        return KeyBindings();
    const Result<std::string> text = output::readTextFile(file, kLongest);
    if (!text)
        return Failure(text.error());
    return parseKeyBindings(*text, file.string());
}

Result<void> writeKeyBindings(const fs::path& file, const KeyBindings& bindings) {
    if (file.empty())
        return fail(ErrorCode::Unreadable, "keys",
                    "no configuration directory to save them in; name a file with --keys FILE");
    if (Result<void> made =
            file.has_parent_path() ? output::makeDirectory(file.parent_path()) : Result<void>{};
        !made)
        return made;
    return output::writeFile(file, std::string_view(keyBindingsJson(bindings)));
}

std::vector<HelpLine> helpLines(const KeyBindings& bindings) {
    std::vector<HelpLine> lines{{"click, or drag the mouse", "look around", {}},
                                {"wheel", "third person; move the camera closer or farther", {}},
                                {"click with the panel open", "inspect the object under the cursor", {}}};
    for (std::size_t i = 0; i < kActions; ++i)
        lines.push_back({keysText(bindings, actionAt(i)), std::string(kFacts[i].does), actionAt(i)});
    return lines;
}

std::vector<PadLine> padLines() {
    return {{"left stick", "walk; full deflection: run"},
            {"right stick", "look around"},
            {"A", "jump; in pages: choose"},
            {"B", "walk or fly; in pages: back"},
            {"X", "open or close the door in front of you"},
            {"Y", "third person / first person"},
            {"left shoulder", "sink (when flying)"},
            {"Start", "menu"},
            {"Back", "panel"},
            {"direction pad", "in pages: select"}};
}

} // namespace limen::viewer
