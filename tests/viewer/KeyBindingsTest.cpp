#include "viewer/KeyBindings.h"

#include "support/TemporaryDirectory.h"

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <set>

namespace limen::viewer {
namespace {

KeyCode key(std::string_view name) {
    return keyNamed(name).value();
}

std::string parseError(const std::string& text) {
    const Result<KeyBindings> parsed = parseKeyBindings(text, "keys.json");
    return parsed ? "none" : parsed.error().message();
}

std::vector<Action> all() {
    std::vector<Action> actions;
    for (std::size_t i = 0; i < kActions; ++i)
        actions.push_back(static_cast<Action>(i));
    return actions;
}

TEST(KeyNames, areFoundWhateverTheirCaseAndNamedBack) {
    EXPECT_EQ(keyNamed("escape"), keyNamed("Escape"));
    EXPECT_EQ(nameOf(key("lEFTSHIFT")), "LeftShift");
    EXPECT_EQ(keyNamed("w"), static_cast<KeyCode>('W'));
    EXPECT_FALSE(keyNamed("Esc"));
    EXPECT_FALSE(keyNamed(""));
    EXPECT_EQ(nameOf(static_cast<KeyCode>(7)), "");
    std::set<std::string_view> names;
    std::set<KeyCode> codes;
    for (const KeyName& known : kKeyNames) {
        EXPECT_TRUE(names.insert(known.name).second) << known.name;
        EXPECT_TRUE(codes.insert(known.code).second) << known.name;
    }
}

TEST(KeyBindings, everyActionHasANameOfItsOwnAndAKeyAtFirst) {
    const KeyBindings bindings;
    for (const Action action : all()) {
        EXPECT_EQ(actionNamed(factsOf(action).name), action);
        EXPECT_FALSE(factsOf(action).does.empty());
        EXPECT_FALSE(bindings.keysOf(action).empty()) << factsOf(action).name;
    }
    EXPECT_FALSE(actionNamed("fly"));
}

TEST(KeyBindings, atFirstNoKeyDoesTwoThingsAtATime) {
    const KeyBindings bindings;
    for (const Action action : all()) {
        for (const KeyCode bound : bindings.keysOf(action)) {
            const std::vector<Action> actions = bindings.actionsOf(bound);
            ASSERT_LE(actions.size(), 2u) << nameOf(bound);
            if (actions.size() == 2) {
                EXPECT_NE(factsOf(actions[0]).when, factsOf(actions[1]).when) << nameOf(bound);
                EXPECT_NE(factsOf(actions[0]).when, When::Always) << nameOf(bound);
                EXPECT_NE(factsOf(actions[1]).when, When::Always) << nameOf(bound);
            }
        }
    }
}

TEST(KeyBindings, filesFromBeforeANewActionStayValid) {
    const Result<KeyBindings> parsed = parseKeyBindings(R"({"rain": "M", "use": ["Tab", "P"]})", "keys.json");
    ASSERT_TRUE(parsed) << parsed.error().message();
    EXPECT_TRUE(parsed->keysOf(Action::Map).empty());
    EXPECT_TRUE(parsed->keysOf(Action::Photo).empty());
    EXPECT_TRUE(parsed->keysOf(Action::Capture).empty());
    EXPECT_EQ(parsed->actionsOf(key("M")), std::vector<Action>{Action::Rain});
    EXPECT_FALSE(parseKeyBindings(R"({"map": "M", "rain": "M"})", "keys.json"));
}

TEST(KeyBindings, aFileChangesTheKeysOfTheActionsThatItNames) {
    const Result<KeyBindings> parsed = parseKeyBindings(
        R"({"forward": ["Z", "up", "z"], "left": "Q", "sink": "LeftControl", "rain": []})", "f");
    ASSERT_TRUE(parsed) << parsed.error().message();
    EXPECT_EQ(keysText(*parsed, Action::Forward), "Z or Up");
    EXPECT_EQ(keysText(*parsed, Action::Left), "Q");
    EXPECT_EQ(keysText(*parsed, Action::Rain), "no key");
    EXPECT_EQ(keysText(*parsed, Action::Back), "S or Down");
    EXPECT_EQ(parsed->actionsOf(key("Q")), std::vector<Action>{Action::Left});
    EXPECT_TRUE(parsed->actionsOf(key("W")).empty());
    EXPECT_EQ(parseKeyBindings("{}", "f").value(), KeyBindings());
}

TEST(KeyBindings, whatIsWrongWithAFileIsSaidWithTheEntry) {
    EXPECT_EQ(parseError("[]"),
              R"(keys.json: is not a JSON object of actions and keys, such as {"use": "F"})");
    EXPECT_EQ(parseError("{"),
              R"(keys.json: is not a JSON object of actions and keys, such as {"use": "F"})");
    EXPECT_EQ(parseError(R"({"fly": "F"})"),
              "keys.json, fly: unknown action; limen view --help lists the actions");
    EXPECT_EQ(parseError(R"({"use": "Esc"})"),
              "keys.json, use: unknown key 'Esc'; use a name such as F, Escape or LeftShift");
    EXPECT_EQ(parseError(R"({"use": 3})"),
              R"(keys.json, use: is neither a key name nor a list of key names, such as "F" or ["W", "Up"])");
    EXPECT_EQ(parseError(R"({"use": ["F", null]})"),
              R"(keys.json, use: is neither a key name nor a list of key names, such as "F" or ["W", "Up"])");
    EXPECT_EQ(parseError(R"({"use": "F", "walk": "F"})"),
              "keys.json, use: F is already the key of walk; give one of them another key");
    EXPECT_EQ(parseError(R"({"rain": "W"})"),
              "keys.json, rain: W is already the key of forward; give one of them another key");
    EXPECT_EQ(parseError(R"({"rain": "E"})"),
              "keys.json, rain: E is already the key of rise; give one of them another key");
    EXPECT_EQ(parseError(R"({"use": "Q", "jump": "E"})"), "none")
        << "one action is for walking, the other for flying";
}

TEST(KeyBindings, aKeyIsTakenFromWhatItDidAtTheSameTimes) {
    KeyBindings bindings;
    bindings.bind(Action::Rain, key("E"), false);
    EXPECT_EQ(keysText(bindings, Action::Rain), "E");
    EXPECT_EQ(keysText(bindings, Action::Use), "no key");
    EXPECT_EQ(keysText(bindings, Action::Rise), "Space");
    bindings.bind(Action::Use, key("F"), false);
    bindings.bind(Action::Use, key("Q"), true); // Q is also the flying key to sink
    EXPECT_EQ(keysText(bindings, Action::Use), "F or Q");
    EXPECT_EQ(keysText(bindings, Action::Sink), "Q or LeftControl");
    bindings.bind(Action::Use, key("Q"), true);
    EXPECT_EQ(keysText(bindings, Action::Use), "F or Q") << "a key is added once";
}

TEST(KeyBindings, whatIsWrittenIsReadBackTheSame) {
    EXPECT_EQ(keyBindingsJson(KeyBindings()), "{}\n");
    KeyBindings bindings;
    bindings.bind(Action::Forward, key("Z"), true);
    bindings.bind(Action::Menu, key("\\"), false);
    bindings.bind(Action::Rain, key("E"), false);
    EXPECT_EQ(parseKeyBindings(keyBindingsJson(bindings), "f").value(), bindings)
        << keyBindingsJson(bindings);
}

TEST(KeyBindings, areKeptInAFileWhoseDirectoryIsMade) {
    const test::TemporaryDirectory directory;
    const std::filesystem::path file = directory.path() / "a" / "b" / "keys.json";
    EXPECT_EQ(readKeyBindings(file, false).value(), KeyBindings());
    EXPECT_FALSE(readKeyBindings(file, true));
    KeyBindings bindings;
    bindings.bind(Action::Use, key("F"), false);
    ASSERT_TRUE(writeKeyBindings(file, bindings));
    EXPECT_EQ(readKeyBindings(file, true).value(), bindings);
    std::ofstream(file) << R"({"use": "nothing"})";
    const Result<KeyBindings> wrong = readKeyBindings(file, false);
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().message(),
              file.string() + ", use: unknown key 'nothing'; use a name such as F, Escape or LeftShift");
    EXPECT_FALSE(writeKeyBindings("", bindings));
}

/// Sets an environment variable and restores it at the end.
class Variable {
public:
    explicit Variable(const char* name) : name_(name) {
        if (const char* value = std::getenv(name))
            before_ = value;
    }
    ~Variable() { set(before_); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;
    void set(const std::optional<std::string>& value) const {
        if (value)
            ::setenv(name_, value->c_str(), 1);
        else
            ::unsetenv(name_);
    }

private:
    const char* name_;
    std::optional<std::string> before_;
};

TEST(KeyBindings, theirFileIsInTheUsersConfiguration) {
    const Variable home("HOME"), config("XDG_CONFIG_HOME");
    home.set("/home/somebody");
    config.set("/configuration");
    EXPECT_EQ(keysPath(), "/configuration/limen/keys.json");
    config.set("not/absolute");
    EXPECT_EQ(keysPath(), "/home/somebody/.config/limen/keys.json");
    config.set({});
    home.set({});
    EXPECT_TRUE(keysPath().empty());
}

TEST(KeyBindings, helpShowsTheKeysThatAreBound) {
    KeyBindings bindings;
    bindings.bind(Action::Use, key("F"), false);
    std::set<Action> told;
    for (const HelpLine& line : helpLines(bindings)) {
        if (!line.action)
            continue;
        EXPECT_EQ(line.keys, keysText(bindings, *line.action));
        EXPECT_EQ(line.does, factsOf(*line.action).does);
        told.insert(*line.action);
    }
    EXPECT_EQ(told.size(), kActions);
}

} // namespace
} // namespace limen::viewer
