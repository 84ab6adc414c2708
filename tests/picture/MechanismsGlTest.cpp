// Every part of the method is needed. With all parts a named view is right to the pixel. Without one, a known
// number of pixels is wrong (docs/proof.md). The numbers hold for the stock driver; others must find some, but for parts
// that correct the snapping of corners: each rasteriser snaps in its own way (an H100's finds none in two of the views).
#include "picture/MechanismScenes.h"
#include "picture/PictureWorld.h"

#include <gtest/gtest.h>

namespace limen::test {
namespace {

/// The omitted part.
struct Off {
    PictureOptions options;
    frame::Rules frame;
    visibility::Rules flood;
};

Off withoutShaderPart(const std::string& macro) {
    Off off;
    off.options.shaderDefines = {macro};
    return off;
}

struct Judged {
    std::uint64_t wrong = 0;
    bool stockDriver = false;
};

Judged judge(NamedView view, const Off& off) {
    PictureOptions options = off.options;
    options.mergeZones = false;
    options.moving = view.moving;
    PictureWorld pictures(view.world, options);
    pictures.width = view.width;
    pictures.height = view.height;
    pictures.fov = view.fov;
    pictures.floodRules = off.flood;
    if (view.doors) {
        motion::DynamicStateInput input;
        input.allDoors = view.doors;
        pictures.setDynamics(input);
    }
    const world::SpaceIndex root = view.root ? pictures.space(view.world.id(*view.root)) : world::kOutside;
    frame::FrameView frame = pictures.look(view.eye, view.yaw, view.pitch, root);
    frame.rules = off.frame;
    const bool stock = pictures.driverVersion().find("Mesa 22.3") != std::string::npos;
    return {pictures.judge(pictures.shoot(frame)).findings(), stock};
}

/// The effect of snapping is visible only where the rasteriser decides coverage.
Off withoutExactOutlines() {
    Off off;
    off.options.exactOutlines = false;
    return off;
}

/// Whether the part corrects the rasteriser's snapping of corners.
enum class Corrects { Geometry, Snapping };

void expectNeeded(NamedView (*view)(), const Off& off, std::uint64_t wrongWithout, const Off& on = {},
                  Corrects corrects = Corrects::Geometry) {
    EXPECT_EQ(judge(view(), on).wrong, 0u) << "with every part";
    const Judged without = judge(view(), off);
    ::testing::Test::RecordProperty("wrong_pixels", std::to_string(without.wrong));
    if (without.stockDriver)
        EXPECT_EQ(without.wrong, wrongWithout);
    else if (corrects == Corrects::Geometry)
        EXPECT_GT(without.wrong, 0u);
}

TEST(Mechanisms, ownershipTarget) {
    Off off;
    off.frame.ownership = false;
    expectNeeded(houseFromTheYard, off, 64);
}

TEST(Mechanisms, entryPlaneTest) {
    expectNeeded(hillBeforeTheTunnel, withoutShaderPart("LIMEN_WITHOUT_ENTRY_TEST"), 24);
}

TEST(Mechanisms, exitPlaneTest) {
    expectNeeded(hillBeforeTheTunnel, withoutShaderPart("LIMEN_WITHOUT_EXIT_TEST"), 1552);
}

TEST(Mechanisms, ancestorClip) {
    Off off;
    off.frame.ancestorClip = false;
    expectNeeded(hallBesideAWindow, off, 112);
}

TEST(Mechanisms, growth) {
    Off off = withoutExactOutlines();
    off.frame.growth = false;
    expectNeeded(roundOpeningsInARow, off, 1, withoutExactOutlines(), Corrects::Snapping);
}

TEST(Mechanisms, eyePlaneClip) {
    Off off;
    off.flood.eyePlaneClip = false;
    expectNeeded(noseInTheDoorway, off, 6144);
}

TEST(Mechanisms, halfPlaneRule) {
    Off off;
    off.flood.halfPlane = false;
    expectNeeded(eyeInTheDoorsPlane, off, 5760);
}

TEST(Mechanisms, nearOpening) {
    Off off = withoutExactOutlines();
    off.frame.nearOpening = false;
    expectNeeded(lintelOfAGate, off, 64, withoutExactOutlines(), Corrects::Snapping);
}

TEST(Mechanisms, siblingOrder) {
    Off off;
    off.flood.siblingOrder = false;
    expectNeeded(doorBehindAWindow, off, 54);
}

TEST(Mechanisms, membership) {
    Off off;
    off.options.omissions.membership = true;
    expectNeeded(someoneInADoorway, off, 213);
}

TEST(Mechanisms, filling) {
    Off off;
    off.options.omissions.fillings = true;
    expectNeeded(shutDoor, off, 392);
}

TEST(Mechanisms, fillingFirst) {
    expectNeeded(boardThroughAShutDoor, withoutShaderPart("LIMEN_WITHOUT_FILLING_FIRST"), 1581);
}

TEST(Mechanisms, viewcone) {
    Off off;
    off.frame.viewcone = false;
    expectNeeded(twoWindowsOnAMeadow, off, 54);
}

TEST(Mechanisms, exactOutlines) {
    Off off;
    off.options.exactOutlines = false;
    expectNeeded(boardsBehindAPanel, off, 63, {}, Corrects::Snapping);
}

TEST(Mechanisms, depthInwards) {
    // Pixel centres are on the edge, which must be hit.
    const Off on = withoutShaderPart("LIMEN_WITHOUT_BESIDE");
    Off off = on;
    off.options.shaderDefines.emplace_back("LIMEN_WITHOUT_DEPTH_INWARDS");
    expectNeeded(eavesBehindAnEdge, off, 17, on);
}

TEST(Mechanisms, fringe) {
    // Pixel centres are on the edges, as above.
    const Off on = withoutShaderPart("LIMEN_WITHOUT_BESIDE");
    Off off = on;
    off.options.shaderDefines.emplace_back("LIMEN_WITHOUT_FRINGE");
    expectNeeded(stepFromAbove, off, 6, on);
}

TEST(Mechanisms, besideCentres) {
    expectNeeded(landingsInAShaft, withoutShaderPart("LIMEN_WITHOUT_BESIDE"), 64);
}

TEST(Mechanisms, gateTolerance) {
    expectNeeded(barsInAnOpening, withoutShaderPart("LIMEN_WITHOUT_GATE_TOLERANCE"),
                 708); // the bars bend the opening's edges
}

} // namespace
} // namespace limen::test
