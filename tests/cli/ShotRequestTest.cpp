#include "cli/ShotRequest.h"

#include "support/TemporaryDirectory.h"

#include <gmock/gmock.h>

namespace limen::cli {
namespace {

using test::putText;
using test::TemporaryDirectory;

ViewArguments at(const std::string& eye) {
    ViewArguments arguments;
    arguments.eye = eye;
    return arguments;
}

TEST(CheckView, fillsInTheDefaults) {
    const engine::ViewRequest view = checkView(at("-1,2,3")).value();
    EXPECT_EQ(view.eye, Vec3(-1, 2, 3));
    EXPECT_TRUE(view.place.empty());
    EXPECT_EQ(view.fov, 60.0);
    EXPECT_FALSE(view.root || view.yaw || view.pitch || view.player);
    EXPECT_EQ(view.scene.weather, engine::Weather::Clear);
}

TEST(CheckView, refusesEachArgumentThatMakesNoSense) {
    const auto refuses = [](std::string ViewArguments::*member, const std::string& text) {
        ViewArguments arguments = at("1,2,3");
        arguments.*member = text;
        const auto view = checkView(arguments);
        EXPECT_FALSE(view) << text;
        EXPECT_TRUE(view || view.error().message().starts_with("--")) << view.error().message();
    };
    refuses(&ViewArguments::eye, "nan,0,0");
    refuses(&ViewArguments::eye, "1e300,0,0");
    refuses(&ViewArguments::at, "hill"); // in addition to --eye
    refuses(&ViewArguments::yaw, "inf");
    refuses(&ViewArguments::pitch, "90.5");
    refuses(&ViewArguments::fov, "0");
    refuses(&ViewArguments::fov, "180");
    refuses(&ViewArguments::size, "0x0");
    refuses(&ViewArguments::root, "0x12");
    refuses(&ViewArguments::player, "1,2");
    refuses(&ViewArguments::time, "1.5");
    refuses(&ViewArguments::weather, "fog");
    refuses(&ViewArguments::body, "1,2");
    refuses(&ViewArguments::bodyYaw, "5"); // without a body
    refuses(&ViewArguments::bodyMetres, "5");
    ASSERT_TRUE(checkView(ViewArguments{}));
    EXPECT_TRUE(checkView(ViewArguments{})->isAtStart) << "no viewpoint: the start of the world";
}

TEST(CheckView, takesABodyAndDoors) {
    ViewArguments arguments = at("1,2,3");
    arguments.body = "4,5,6";
    arguments.bodyYaw = "90";
    arguments.bodyRoot = "0xA9B40105";
    arguments.bodyOpacity = "0.5";
    arguments.eachDoor = {"inn.front=0.25", "a=b=1"};
    const engine::ViewRequest view = checkView(arguments).value();
    ASSERT_TRUE(view.scene.body);
    EXPECT_EQ(view.scene.body->feet, Vec3(4, 5, 6));
    EXPECT_EQ(view.scene.body->yaw, 90.0);
    EXPECT_EQ(view.scene.body->root.cell, 0xA9B40105u);
    EXPECT_EQ(view.scene.body->opacity, 0.5);
    ASSERT_EQ(view.scene.eachDoor.size(), 2u);
    EXPECT_EQ(view.scene.eachDoor[0].name, "inn.front");
    EXPECT_EQ(view.scene.eachDoor[0].open, 0.25);
    EXPECT_EQ(view.scene.eachDoor[1].name, "a=b");
}

TEST(CheckView, refusesDoorsThatMakeNoSense) {
    for (const char* bad : {"front", "=1", "front=2", "front=", "front=open"}) {
        ViewArguments arguments = at("1,2,3");
        arguments.eachDoor = {bad};
        EXPECT_FALSE(checkView(arguments)) << bad;
    }
    ViewArguments both = at("1,2,3");
    both.eachDoor = {"front=1"};
    both.doors = "open";
    EXPECT_FALSE(checkView(both));
    ViewArguments two = at("1,2,3");
    two.player = two.body = "1,2,3";
    EXPECT_FALSE(checkView(two)) << "the body sets the position of the player";
}

TEST(ReadViews, takesWhatALineDoesNotSayFromTheCommandLine) {
    const TemporaryDirectory directory;
    putText(directory / "views", "# a comment\n\n--eye 1,2,3 --yaw 90 --size 10x20\n--eye=-4,5,6 --ids "
                                 "my.npy\n --at '0xA9B40031 [1 2 3]' \r\n");
    ViewArguments common;
    common.fov = "75";
    OutputPaths outputs;
    outputs.json = "frame.json";
    const auto views = readViews(directory / "views", common, outputs, "out");
    ASSERT_TRUE(views) << views.error().message();
    ASSERT_EQ(views->size(), 3u);
    EXPECT_EQ((*views)[0].view.fov, 75.0);
    EXPECT_EQ((*views)[0].view.size.width, 10u);
    EXPECT_EQ((*views)[1].view.eye, Vec3(-4, 5, 6));
    EXPECT_EQ((*views)[1].view.size.width, 1280u);
    EXPECT_EQ((*views)[2].view.eye, Vec3(0xA9 * 192.0 + 1, 0xB4 * 192.0 + 2, 3));
    EXPECT_EQ((*views)[2].view.root.value().rule, engine::RootChoice::Rule::Outside);
    EXPECT_EQ((*views)[0].outputs.frame, "out/0000.png");
    EXPECT_EQ((*views)[0].outputs.json, "out/0000.frame.json");
    EXPECT_EQ((*views)[1].outputs.ids, "out/my.npy");
    EXPECT_EQ((*views)[1].outputs.frame, "");
    EXPECT_EQ((*views)[2].outputs.frame, "out/0002.png");
}

TEST(ReadViews, namesTheLineThatMakesNoSense) {
    const TemporaryDirectory directory;
    for (const char* bad :
         {"--eye 1,2", "--eye 1,2,3 --unknown 4", "--eye 1,2,3 stray", "--eye", "--yaw 5", "--at 'open"}) {
        putText(directory / "views", std::string("--eye 1,2,3\n") + bad + "\n");
        const auto views = readViews(directory / "views", {}, {}, "out");
        ASSERT_FALSE(views) << bad;
        EXPECT_THAT(views.error().message(), testing::HasSubstr("line 2")) << bad;
    }
    putText(directory / "views", "# nothing\n");
    EXPECT_FALSE(readViews(directory / "views", {}, {}, "out"));
    EXPECT_FALSE(readViews(directory / "missing", {}, {}, "out"));
    EXPECT_FALSE(readViews(directory.path(), {}, {}, "out"));
}

TEST(CheckOutputs, refusesTheSameFileTwice) {
    const TemporaryDirectory directory;
    const std::vector<std::filesystem::path> same{directory / "a.png", directory / "./a.png"};
    EXPECT_FALSE(checkOutputs(same));
    const std::vector<std::filesystem::path> fine{directory / "a.png", directory / "b.png"};
    EXPECT_TRUE(checkOutputs(fine));
}

} // namespace
} // namespace limen::cli
