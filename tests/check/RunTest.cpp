#include "check/Run.h"

#include "check/House.h"
#include "engine/Camera.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <set>
#include <thread>

namespace limen::check {
namespace {

using test::House;

/// A drawer that traces: right to the bit, except for the faults that a test switches on.
struct TracingDrawer final : Drawer {
    const House& house;
    std::function<void(const View&, std::size_t shot, DrawnImages&)> breakIt;
    std::size_t shots = 0, failAfter = 1u << 30;
    bool loads = true;
    std::function<std::unique_ptr<TracingDrawer>()> helps;

    explicit TracingDrawer(const House& h) : house(h) {}

    world::DynamicState still;
    std::vector<std::weak_ptr<const world::World>> given;
    std::vector<dat::BlockCoord> expected;
    Result<std::shared_ptr<const world::World>> load(dat::BlockCoord block) override {
        EXPECT_EQ(block, house.source.home());
        if (!loads)
            return fail(ErrorCode::Malformed, "block", "is damaged");
        const auto loaded = std::make_shared<const world::World>(house.world);
        given.push_back(loaded);
        return loaded;
    }
    void expect(dat::BlockCoord block) override { expected.push_back(block); }
    const world::DynamicState& dynamics() const override { return still; }
    reference::Camera cameraOf(const View& view, world::SpaceIndex root) override {
        const engine::CameraBasis axes = engine::basisOf({view.yaw, view.pitch});
        reference::Camera camera{view.eye, axes.right, axes.up, axes.forward};
        camera.tanHalfY = std::tan(view.fov * 0.00872664625997165);
        camera.tanHalfX = camera.tanHalfY * view.width / view.height;
        camera.width = view.width;
        camera.height = view.height;
        camera.root = root;
        return camera;
    }
    Result<std::unique_ptr<Drawer>> makeHelper() override {
        return helps ? std::unique_ptr<Drawer>(helps()) : nullptr;
    }
    Result<DrawnImages> draw(const View& view, world::SpaceIndex root, bool colour) override {
        if (shots++ >= failAfter)
            return fail(ErrorCode::Driver, "", "is gone");
        reference::Picture traced;
        reference::tracePicture(*house.scene, cameraOf(view, root), 1, traced);
        DrawnImages images;
        images.width = view.width;
        images.height = view.height;
        for (int y = 0; y < static_cast<int>(view.height); ++y) {
            for (int x = 0; x < static_cast<int>(view.width); ++x) {
                const reference::Answer& a = traced.at(x, y);
                images.ids.push_back(a.id);
                images.depth.push_back(a.id < 2 ? 0.0f : static_cast<float>(0.02 / a.t));
            }
        }
        if (colour)
            images.colour.assign(images.ids.size() * 4, 7);
        if (breakIt)
            breakIt(view, shots, images);
        return images;
    }
};

struct SmallRun {
    House house;
    TracingDrawer drawer{house};
    RunRequest request;
    Progress progress;

    explicit SmallRun(std::size_t views = 60) {
        const std::vector<BlockSummary> blocks{{house.source.home(), 2, true, true}};
        constexpr std::array<ViewKind, kKindCount> kAll{
            ViewKind::Random, ViewKind::Outside,  ViewKind::Path,      ViewKind::Sweep,
            ViewKind::Still,  ViewKind::Straddle, ViewKind::Telephoto, ViewKind::Wide};
        request.tasks = planTasks(blocks, house.tour, shareAmongKinds(views, kAll));
        request.width = request.sweepWidth = 24;
        request.height = request.sweepHeight = 16;
        request.tour = house.tour;
    }
    Totals run(const RunEvents& events = {}) {
        const Result<void> done = runCheck(request, drawer, events, progress);
        EXPECT_TRUE(done) << (done ? "" : done.error().message());
        return progress.totals;
    }
};

TEST(Run, aRightPictureHasNoFindings) {
    SmallRun small;
    const Totals totals = small.run();
    EXPECT_GT(totals.sum().views, 50u);
    EXPECT_LE(totals.sum().views, viewsAsked(small.request));
    for (const KindTotals& kind : totals.kinds)
        EXPECT_GT(kind.views, 0u);
    EXPECT_EQ(totals.sum().findings(), 0u);
    EXPECT_TRUE(totals.worst.empty());
}

TEST(Run, oneWrongPixelIsAFindingWithACommand) {
    SmallRun small;
    small.drawer.breakIt = [](const View&, std::size_t shot, DrawnImages& images) {
        if (shot == 5)
            images.ids[100] = 0xFFFFFF;
    };
    std::size_t pictures = 0;
    RunEvents events;
    events.picture = [&](const FindingPicture& finding) {
        ++pictures;
        EXPECT_EQ(finding.comparison.verdicts[100], Verdict::Disagrees);
        EXPECT_EQ(finding.number, 4u);
        return Result<void>{};
    };
    const Totals totals = small.run(events);
    EXPECT_EQ(totals.sum().disagreeing(), 1u);
    EXPECT_EQ(pictures, 1u);
    ASSERT_EQ(totals.worst.size(), 1u);
    const std::vector<View> views =
        viewsOf(small.request, small.request.tasks[0], small.house.world, *small.house.scene);
    EXPECT_EQ(shotOptions(totals.worst[0].view), shotOptions(views[4]));
}

TEST(Run, viewsOfAnySizeDifferInSizeAndInNothingElse) {
    SmallRun small;
    const auto viewsNow = [&] {
        return viewsOf(small.request, small.request.tasks[0], small.house.world, *small.house.scene);
    };
    const std::vector<View> usual = viewsNow();
    small.request.anySize = true;
    const std::vector<View> any = viewsNow(), again = viewsNow();
    ASSERT_EQ(any.size(), usual.size());
    std::set<std::pair<std::uint32_t, std::uint32_t>> sizes;
    for (std::size_t i = 0; i < any.size(); ++i) {
        EXPECT_EQ(any[i].eye, usual[i].eye);
        EXPECT_EQ(shotOptions(any[i]), shotOptions(again[i]));
        EXPECT_GE(std::min(any[i].width, any[i].height), kLeastSide);
        EXPECT_LE(any[i].width, kMostWidth);
        EXPECT_LE(any[i].height, kMostHeight);
        EXPECT_LE(std::max(any[i].width, any[i].height), 4 * std::min(any[i].width, any[i].height) + 4);
        sizes.insert({any[i].width, any[i].height});
    }
    EXPECT_GT(sizes.size(), any.size() / 2); // tools/check-sweep draws such views
}

TEST(Run, aWrongDepthIsAFinding) {
    SmallRun small;
    small.drawer.breakIt = [](const View&, std::size_t, DrawnImages& images) {
        for (float& depth : images.depth)
            depth *= 1.01f;
    };
    const Totals totals = small.run();
    EXPECT_EQ(totals.sum().disagreeing(), 0u);
    EXPECT_GT(totals.sum().count(Verdict::Depth), 1000u);
}

TEST(Run, aPictureThatChangesWhileNothingMovesIsAFinding) {
    SmallRun small;
    small.drawer.breakIt = [](const View&, std::size_t shot, DrawnImages& images) {
        if (!images.colour.empty())
            images.colour[0] = static_cast<std::uint8_t>(shot);
    };
    const Totals totals = small.run();
    EXPECT_EQ(totals.kinds[static_cast<std::size_t>(ViewKind::Still)].moved,
              totals.kinds[static_cast<std::size_t>(ViewKind::Still)].views);
    EXPECT_GT(totals.sum().findings(), 0u);
}

TEST(Run, everyVoidIsSeen) {
    SmallRun small;
    small.drawer.breakIt = [](const View&, std::size_t shot, DrawnImages& images) {
        if (shot == 3)
            images.ids[7] = 0;
    };
    EXPECT_EQ(small.run().sum().count(Verdict::Void), 1u);
}

TEST(Run, aStoppedRunContinuesAndEndsAsAWholeOne) {
    const auto breakSome = [](const View& view, std::size_t, DrawnImages& images) {
        if (view.kind == ViewKind::Sweep)
            images.ids[3] = 0xFFFFFF;
    };
    SmallRun whole, stopped;
    whole.drawer.breakIt = stopped.drawer.breakIt = breakSome;
    const Totals all = whole.run();
    stopped.drawer.failAfter = 25;
    EXPECT_FALSE(runCheck(stopped.request, stopped.drawer, {}, stopped.progress));
    EXPECT_EQ(stopped.progress.totals.sum().views, 25u);
    const auto kept = parseProgress(progressJson(stopped.progress));
    ASSERT_TRUE(kept);
    stopped.progress = *kept;
    stopped.drawer.failAfter = 1u << 30;
    Totals continued = stopped.run();
    EXPECT_LT(stopped.drawer.shots, whole.drawer.shots + 3) << "nothing is done twice";
    continued.seconds = all.seconds;
    continued.drawSeconds = all.drawSeconds;
    continued.traceSeconds = all.traceSeconds;
    EXPECT_EQ(reportJson(continued, {}), reportJson(all, {}));
    EXPECT_GT(all.sum().disagreeing(), 0u);
}

TEST(Run, aFinishedRunIsNotDoneAgain) {
    SmallRun small;
    small.run();
    const std::size_t shots = small.drawer.shots;
    small.run();
    EXPECT_EQ(small.drawer.shots, shots);
}

TEST(Run, blocksFollowEachOtherInOrderAndAreLetGo) {
    const auto breakSome = [](const View& view, std::size_t, DrawnImages& images) {
        if (view.kind == ViewKind::Path)
            images.ids[3] = 0xFFFFFF;
    };
    SmallRun once, twice;
    twice.request.tasks.push_back(twice.request.tasks[0]);
    once.drawer.breakIt = twice.drawer.breakIt = breakSome;
    const Totals single = once.run(), both = twice.run();
    EXPECT_EQ(both.sum().views, 2 * single.sum().views);
    EXPECT_EQ(both.sum().counts[static_cast<std::size_t>(Verdict::Disagrees)],
              2 * single.sum().counts[static_cast<std::size_t>(Verdict::Disagrees)]);
    ASSERT_EQ(both.worst.size(), 2 * single.worst.size());
    for (std::size_t i = 0; i < single.worst.size(); ++i) { // equal counts: in the order of views
        EXPECT_EQ(both.worst[i].number, single.worst[i].number);
        EXPECT_EQ(both.worst[single.worst.size() + i].number, single.worst[i].number + single.sum().views);
    }
    EXPECT_EQ(twice.progress.tasks, 2u);
    EXPECT_EQ(twice.drawer.expected, std::vector{twice.house.source.home()});
    for (const auto& world : twice.drawer.given)
        EXPECT_TRUE(world.expired());
}

/// A run with a helper. The drawer's third view and all after it wait until the helper has drawn.
struct HelpedRun : SmallRun {
    std::atomic<std::size_t> helpersShots{0};
    std::size_t helperFailsAfter = 1u << 30;
    bool helperLoads = true;

    HelpedRun() : SmallRun(400) {
        drawer.helps = [this] {
            auto helper = std::make_unique<TracingDrawer>(house);
            helper->failAfter = helperFailsAfter;
            helper->loads = helperLoads;
            helper->breakIt = [this](const View& view, std::size_t, DrawnImages& images) {
                ++helpersShots;
                breakSome(view, images);
            };
            return helper;
        };
        drawer.breakIt = [this](const View& view, std::size_t shot, DrawnImages& images) {
            breakSome(view, images);
            for (int i = 0; i < 5000 && shot > 2 && waits && helpersShots == 0; ++i)
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
        };
    }
    static void breakSome(const View& view, DrawnImages& images) {
        if (view.kind == ViewKind::Sweep)
            images.ids[3] = 0xFFFFFF;
    }
    bool waits = true;
};

std::string reportOf(Totals totals) {
    totals.seconds = totals.drawSeconds = totals.traceSeconds = 1.0;
    return reportJson(totals, {});
}

TEST(Run, whatAHelperDrawsCountsAsIfOneHadDrawnAll) {
    HelpedRun alone, helped;
    alone.drawer.helps = nullptr;
    alone.waits = false;
    const std::string expected = reportOf(alone.run());
    EXPECT_EQ(reportOf(helped.run()), expected);
    EXPECT_GT(helped.helpersShots, 0u);
    EXPECT_EQ(helped.drawer.shots + helped.helpersShots, alone.drawer.shots);
    EXPECT_GT(helped.progress.totals.sum().disagreeing(), 0u);
}

TEST(Run, whatAHelperCannotDrawFailsTheRunWhichCanBeContinued) {
    HelpedRun alone, helped;
    alone.drawer.helps = nullptr;
    alone.waits = false;
    helped.helperFailsAfter = 20;
    EXPECT_FALSE(runCheck(helped.request, helped.drawer, {}, helped.progress));
    EXPECT_LT(helped.progress.views, 400u);
    helped.drawer.helps = nullptr;
    EXPECT_EQ(reportOf(helped.run()), reportOf(alone.run())) << "nothing is left out, nothing done twice";
}

TEST(Run, withoutAHelpersWorldTheDrawerDrawsAll) {
    HelpedRun alone, helped;
    alone.drawer.helps = nullptr;
    alone.waits = helped.waits = false;
    helped.helperLoads = false;
    EXPECT_EQ(reportOf(helped.run()), reportOf(alone.run()));
    EXPECT_EQ(helped.helpersShots, 0u);
}

TEST(Run, savesItsStateAtTheEnd) {
    SmallRun small(10);
    Progress last;
    RunEvents events;
    events.saved = [&](const Progress& state) {
        last = state;
        return Result<void>{};
    };
    const Totals totals = small.run(events);
    EXPECT_EQ(last.tasks, 1u);
    EXPECT_EQ(last.totals.sum().views, totals.sum().views);
}

TEST(Run, aBlockThatCannotBeLoadedIsCounted) {
    SmallRun small;
    small.drawer.loads = false;
    std::string said;
    RunEvents events;
    events.leftOut = [&](dat::BlockCoord, const Error& error) { said = error.message(); };
    const Totals totals = small.run(events);
    EXPECT_EQ(totals.sum().views, 0u);
    EXPECT_EQ(totals.blocksLeftOut, 1u);
    EXPECT_EQ(said, "block: is damaged");
}

TEST(Run, aPictureThatCannotBeWrittenIsAnError) {
    SmallRun small(10);
    small.drawer.breakIt = [](const View&, std::size_t, DrawnImages& images) { images.ids[0] = 0xFFFFFF; };
    RunEvents events;
    events.picture = [](const FindingPicture&) -> Result<void> {
        return fail(ErrorCode::Unreadable, "x.png", "the disk is full");
    };
    EXPECT_FALSE(runCheck(small.request, small.drawer, events, small.progress));
}

} // namespace
} // namespace limen::check
