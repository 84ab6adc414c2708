#include "play/WalkRecord.h"

#include <gmock/gmock.h>

namespace limen::play {
namespace {

using testing::HasSubstr;

RecordedFrame someFrame() {
    RecordedFrame frame;
    frame.input.seconds = 1.0 / 60.0;
    frame.input.forward = -1.0;
    frame.input.turnRight = 0.1 + 0.2; // not a short decimal
    frame.input.jump = true;
    frame.input.size = {640, 360};
    frame.input.acts = {{PlayActKind::Use}, {PlayActKind::Time, 0.3}, {PlayActKind::Distance, 2.5}};
    frame.decided = 0xFEDCBA9876543210u;
    return frame;
}

TEST(WalkRecord, isReadAsItWasWritten) {
    RecordedFrame still;
    still.input.size = {1, 2};
    const std::string text =
        beginningLine("--eye=1,2,3 --root=outside") + frameLine(someFrame()) + frameLine(still);
    const Result<WalkRecord> walk = parseWalk(text, "w");
    ASSERT_TRUE(walk) << walk.error().message();
    EXPECT_EQ(walk->start, "--eye=1,2,3 --root=outside");
    ASSERT_EQ(walk->frames.size(), 2u);
    EXPECT_EQ(walk->frames[0].input, someFrame().input);
    EXPECT_EQ(walk->frames[0].decided, someFrame().decided);
    EXPECT_EQ(walk->frames[1].input, still.input);
}

TEST(WalkRecord, tellsWhatWasStreamedAndWhenItWasShown) {
    RecordedFrame frame = someFrame();
    frame.shown = engine::PartTarget{{0xA9, 0xB4}, {.radius = 4, .detail = 0.75, .farRadius = 12}};
    frame.isRefused = true;
    world::LoadOptions nearest{.radius = 2};
    nearest.detail = std::numeric_limits<double>::infinity();
    const Result<WalkRecord> walk =
        parseWalk(beginningLine("--eye=1,2,3", nearest) + frameLine(frame) + frameLine(someFrame()), "w");
    ASSERT_TRUE(walk) << walk.error().message();
    EXPECT_EQ(walk->streamed, nearest);
    EXPECT_EQ(walk->frames[0].shown, frame.shown);
    EXPECT_EQ(walk->frames[0].input, frame.input);
    EXPECT_TRUE(walk->frames[0].isRefused);
    EXPECT_FALSE(walk->frames[1].shown);
    EXPECT_FALSE(walk->frames[1].isRefused);
    EXPECT_FALSE(parseWalk(beginningLine("") + frameLine(frame), "w")->streamed);
}

TEST(WalkRecord, everyActHasAName) {
    RecordedFrame frame;
    for (std::size_t kind = 0; kind < PlayAct::kKinds; ++kind)
        frame.input.acts.push_back({static_cast<PlayActKind>(kind), static_cast<double>(kind)});
    const Result<WalkRecord> walk = parseWalk(beginningLine("") + frameLine(frame), "w");
    ASSERT_TRUE(walk);
    EXPECT_EQ(walk->frames[0].input.acts, frame.input.acts);
    EXPECT_EQ(static_cast<std::size_t>(PlayActKind::Object) + 1, PlayAct::kKinds);
}

TEST(WalkRecord, aPointOfTheMapHasTwoNumbers) {
    RecordedFrame frame;
    frame.input.acts = {{PlayActKind::Go, 32530.25, 34660.5}};
    const Result<WalkRecord> walk = parseWalk(beginningLine("") + frameLine(frame), "w");
    ASSERT_TRUE(walk) << walk.error().message();
    EXPECT_EQ(walk->frames[0].input.acts, frame.input.acts);
    for (const char* acts :
         {R"([["go",1]])", R"([["go",1,"2"]])", R"([["go",1,2,3]])", R"([["time",0.5,1]])"})
        EXPECT_FALSE(parseWalk(beginningLine("") + R"({"size":[4,4],"acts":)" + acts + "}\n", "w")) << acts;
}

TEST(WalkRecord, refusesWhatIsNoWalkAndSaysWhere) {
    const std::string begin = beginningLine("--eye=1,2,3"), frame = frameLine(someFrame());
    for (const std::string& text :
         {std::string(), std::string("{}\n"), std::string("walk\n"), frame, begin,
          std::string(R"({"format":"limen walk","version":2,"start":""})") + "\n" + frame,
          std::string(R"({"format":"limen walk","version":1,"start":7})") + "\n" + frame,
          std::string(R"({"format":"limen walk","version":1,"start":"","streamed":3})") + "\n" + frame})
        EXPECT_FALSE(parseWalk(text, "w")) << text;
    for (const char* bad : {"",
                            "[]",
                            "{",
                            R"({"seconds":"1"})",
                            R"({"seconds":-1})",
                            R"({"seconds":1e999})",
                            R"({"jump":1})",
                            R"({"size":[0,5]})",
                            R"({"size":[640]})",
                            R"({"size":[99999,5]})",
                            R"({"acts":"use"})",
                            R"({"acts":[["fly",0]]})",
                            R"({"acts":[["use"]]})",
                            R"({"acts":[[0,0]]})",
                            R"({"decided":"xyz"})",
                            R"({"decided":5})",
                            R"({"refused":1})",
                            R"({"shown":{}})",
                            R"({"shown":{"x":1,"y":300,"radius":4,"far":0}})",
                            R"({"shown":{"x":1,"y":2,"radius":-4,"far":0}})",
                            R"({"shown":{"x":1,"y":2,"radius":4,"far":1e9}})",
                            R"({"shown":{"x":1,"y":2,"radius":4,"far":0,"detail":0}})"}) {
        const Result<WalkRecord> walk = parseWalk(begin + frame + bad + "\n", "my walk");
        ASSERT_FALSE(walk) << bad;
        EXPECT_THAT(walk.error().message(), HasSubstr("my walk"));
        EXPECT_THAT(walk.error().message(), HasSubstr("line 3")) << bad;
    }
}

} // namespace
} // namespace limen::play
