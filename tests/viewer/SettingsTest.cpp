#include "viewer/settings/Settings.h"

#include "support/TemporaryDirectory.h"

#include <fstream>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace limen::viewer {
namespace {

Settings unusual() {
    Settings settings;
    settings.recent = {"/games/ac", "", "/tmp/other"};
    settings.lastPlaces["/games/ac"] = {"town", {1.5, -2.25, 3.0}, 90.0, -10.0, 0xA9B40100};
    settings.quality = "low";
    settings.look = world::Look::Enhanced;
    settings.scale = {65, 45.0};
    settings.uiScale = 1.5;
    settings.mouse = MouseMode::Drag;
    settings.sensitivity = 2.0;
    settings.invertY = true;
    settings.fieldOfView = 75.0;
    settings.width = 800;
    settings.height = 600;
    settings.isFullScreen = true;
    return settings;
}

TEST(Settings, comeBackAsTheyWereWritten) {
    const Result<SettingsFile> read = parseSettings(settingsText(unusual(), ""));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->settings, unusual());
    EXPECT_THAT(read->notes, testing::IsEmpty());
}

TEST(Settings, keepTheKeysOfOtherPrograms) {
    const std::string before =
        R"({"mouse": "drag", "theme": {"name": "dark"}, "window": {"x": 7, "width": 640}, "last_places": {"w": 3}})";
    const auto json = nlohmann::json::parse(settingsText(unusual(), before));
    EXPECT_EQ(json["theme"]["name"], "dark");
    EXPECT_EQ(json["window"]["x"], 7);
    EXPECT_EQ(json["window"]["width"], 800);
    EXPECT_EQ(json["last_places"]["w"], 3);
    EXPECT_EQ(json["last_places"]["/games/ac"]["x"], 1.5);
}

TEST(Settings, replaceAWrongValueByItsDefaultWithANote) {
    const Result<SettingsFile> read = parseSettings(
        R"({"ui_scale": 900, "quality": "best", "invert_y": 1, "field_of_view": "wide", "mouse_sensitivity": 3})");
    ASSERT_TRUE(read);
    Settings expected;
    expected.sensitivity = 3.0;
    EXPECT_EQ(read->settings, expected);
    EXPECT_EQ(read->notes.size(), 4u);
    EXPECT_THAT(read->notes, testing::Contains(testing::HasSubstr("ui_scale: ignored")));
}

TEST(Settings, theScaleIsAPercentageOrAutomatic) {
    const auto json = nlohmann::json::parse(settingsText(Settings(), ""));
    EXPECT_EQ(json["scale"], "auto");
    EXPECT_EQ(json["frame_rate"], "auto");
    const Result<SettingsFile> read = parseSettings(R"({"scale": 70, "frame_rate": 60})");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->settings.scale, (ScaleWish{70, 60.0}));
    for (const char* wrong : {R"({"scale": 49})", R"({"scale": "half"})", R"({"frame_rate": 0})"}) {
        const Result<SettingsFile> ignored = parseSettings(wrong);
        ASSERT_TRUE(ignored);
        EXPECT_EQ(ignored->settings.scale, ScaleWish());
        EXPECT_EQ(ignored->notes.size(), 1u) << wrong;
    }
}

TEST(Settings, keepAFileThatIsNoJsonBesideTheNewOne) {
    const test::TemporaryDirectory work;
    const std::filesystem::path file = work.path() / "settings.json";
    std::ofstream(file) << "{ not json";
    const SettingsFile read = readSettings(file);
    EXPECT_EQ(read.settings, Settings());
    ASSERT_EQ(read.notes.size(), 1u);
    EXPECT_THAT(read.notes[0], testing::HasSubstr("settings.json.bad"));
    ASSERT_TRUE(writeSettings(file, unusual()));
    EXPECT_EQ(readSettings(file).settings, unusual());
    std::string kept;
    std::getline(std::ifstream(work.path() / "settings.json.bad"), kept);
    EXPECT_EQ(kept, "{ not json");
}

TEST(Settings, areTheDefaultsWithoutAFile) {
    const test::TemporaryDirectory work;
    EXPECT_EQ(readSettings(work.path() / "none.json").settings, Settings());
    EXPECT_FALSE(writeSettings({}, Settings()));
    EXPECT_TRUE(writeSettings(work.path() / "new" / "settings.json", unusual())); // makes the directory
}

TEST(Settings, putAWorldAtTheHeadOnce) {
    Settings settings;
    for (int i = 0; i < 20; ++i)
        addRecent(settings, "/w" + std::to_string(i % 10));
    EXPECT_EQ(settings.recent.size(), Settings::kMostRecent);
    EXPECT_EQ(settings.recent.front(), "/w9");
    addRecent(settings, "/w5");
    EXPECT_EQ(settings.recent.front(), "/w5");
    EXPECT_EQ(std::count(settings.recent.begin(), settings.recent.end(), "/w5"), 1);
}

} // namespace
} // namespace limen::viewer
