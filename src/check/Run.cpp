#include "check/Run.h"

#include "check/DrawingHelper.h"
#include "check/views/RandomGenerator.h"
#include "check/views/Views.h"

#include <algorithm>
#include <chrono>
#include <numeric>

namespace limen::check {

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kBetweenSaves = std::chrono::seconds(5);
/// Views of a block that are worth a helper: taking over the loaded world takes as long as some dozens of
/// views.
constexpr std::size_t kWorthHelp = 100;

std::size_t askedOf(const RunRequest& request, const BlockTask& task) {
    return task.total() + tourPointsIn(request.tour, task.tourViews, task.block);
}

/// One run.
class Runner {
public:
    Runner(const RunRequest& request, Drawer& drawer, const RunEvents& events, Progress& progress)
        : request_(request), drawer_(drawer), events_(events), progress_(progress),
          secondsBefore_(progress.totals.seconds) {}

    Result<void> run() {
        const std::size_t done = progress_.tasks;
        for (std::size_t i = 0; i < request_.tasks.size(); ++i) {
            if (i >= done) {
                if (Result<void> ran = runTask(i); !ran)
                    return ran;
            }
            asked_ += askedOf(request_, request_.tasks[i]);
            step(0);
        }
        if (Result<void> finished = finishBlock(); !finished)
            return finished;
        return save(progress_);
    }

private:
    /// A block of the run. Its last views are judged while the next block is loaded.
    struct Block {
        explicit Block(std::shared_ptr<const world::World> loaded)
            : world(std::move(loaded)), traced(*world) {}
        std::shared_ptr<const world::World> world;
        TracedWorld traced;
        std::optional<Judging> judging;
    };

    Result<void> runTask(std::size_t index) {
        const BlockTask& task = request_.tasks[index];
        const auto loaded = drawer_.load(task.block);
        if (index + 1 < request_.tasks.size())
            drawer_.expect(request_.tasks[index + 1].block);
        std::unique_ptr<Block> next = loaded ? std::make_unique<Block>(*loaded) : nullptr;
        const std::vector<View> views =
            loaded ? viewsOf(request_, task, **loaded, next->traced.scene()) : std::vector<View>{};
        if (Result<void> finished = finishBlock(); !finished)
            return finished;
        if (!loaded) { // one damaged block among thousands does not end the run; the report counts it
            ++progress_.totals.blocksLeftOut;
            if (events_.leftOut)
                events_.leftOut(task.block, loaded.error());
            endTask();
            return {};
        }
        block_ = std::move(next);
        return drawViews(task.block, views);
    }

    Result<void> drawViews(dat::BlockCoord block, const std::vector<View>& views) {
        const std::size_t first = progress_.views;
        Judging& judging = block_->judging.emplace(block_->traced, first, request_.threads,
                                                   drawer_.idColour(), events_, progress_);
        ViewQueue queue(*block_->world, views, first);
        const bool helped = views.size() >= first + kWorthHelp;
        if (helped && !helper_)
            helper_.emplace(drawer_);
        if (helped)
            helper_->start(block, queue, judging);
        Result<void> drawn = drawAll(queue, drawer_, judging, [&](std::size_t index) -> Result<void> {
            step(index + 1);
            if (events_.stopped && events_.stopped())
                return fail(ErrorCode::Unsupported, "check", "was stopped before its last view");
            return Clock::now() - saved_ > kBetweenSaves ? save(judging.progress()) : Result<void>{};
        });
        Result<void> helpersDrawn = helped ? helper_->finish() : Result<void>{};
        return drawn ? std::move(helpersDrawn) : std::move(drawn);
    }

    /// Waits until the block's views are judged, and releases it.
    Result<void> finishBlock() {
        if (!block_)
            return {};
        Result<void> judged = block_->judging->finish();
        block_.reset();
        if (judged)
            endTask();
        return judged;
    }

    void endTask() {
        ++progress_.tasks;
        progress_.views = 0;
    }

    void step(std::size_t inTask) const {
        if (events_.step)
            events_.step(asked_ + inTask);
    }

    [[nodiscard]] double seconds() const {
        return secondsBefore_ + std::chrono::duration<double>(Clock::now() - start_).count();
    }

    Result<void> save(Progress state) {
        saved_ = Clock::now();
        state.totals.seconds = seconds();
        return events_.saved ? events_.saved(state) : Result<void>{};
    }

    const RunRequest& request_;
    Drawer& drawer_;
    const RunEvents& events_;
    Progress& progress_;
    const double secondsBefore_;
    const Clock::time_point start_ = Clock::now();
    Clock::time_point saved_ = start_;
    std::size_t asked_ = 0;        ///< views of the finished tasks
    std::unique_ptr<Block> block_; ///< the block whose views are drawn or judged
    std::optional<DrawingHelper> helper_;
};

} // namespace

std::size_t viewsAsked(const RunRequest& request) {
    return std::accumulate(
        request.tasks.begin(), request.tasks.end(), std::size_t{0},
        [&](std::size_t sum, const BlockTask& task) { return sum + askedOf(request, task); });
}

namespace {

/// Small sizes are as frequent as large ones.
void setAnySize(View& view, RandomGenerator random) {
    constexpr double kMostAspect = 4.0;
    const auto pixels = [](double side, std::uint32_t most) {
        return std::clamp(static_cast<std::uint32_t>(side), kLeastSide, most);
    };
    const double width = random.betweenLog(kLeastSide, kMostWidth + 1.0);
    view.width = pixels(width, kMostWidth);
    view.height = pixels(width * random.betweenLog(1.0 / kMostAspect, kMostAspect), kMostHeight);
    view.width = std::min(view.width, static_cast<std::uint32_t>(kMostAspect) * view.height);
}

} // namespace

std::vector<View> viewsOf(const RunRequest& request, const BlockTask& task, const world::World& world,
                          const reference::Scene& scene) {
    Surroundings around{world, scene, task.block, request.seed, request.width, request.height, request.tour};
    const auto count = [&](ViewKind kind) { return task.counts[static_cast<std::size_t>(kind)]; };
    std::vector<View> views;
    addRandomViews(around, ViewKind::Random, count(ViewKind::Random), views);
    addOutsideViews(around, count(ViewKind::Outside), views);
    if (task.tourViews > 0)
        addTourViews(around, task.tourViews, views);
    addWalkViews(around, count(ViewKind::Path), views);
    addRandomViews(around, ViewKind::Still, count(ViewKind::Still), views);
    addLensViews(around, ViewKind::Telephoto, count(ViewKind::Telephoto), views);
    addLensViews(around, ViewKind::Wide, count(ViewKind::Wide), views);
    around.width = request.sweepWidth;
    around.height = request.sweepHeight;
    addSweepViews(around, count(ViewKind::Sweep), views);
    addStraddleViews(around, count(ViewKind::Straddle), views);
    for (std::size_t i = 0; i < views.size(); ++i) {
        RandomGenerator random(request.seed, {0x74696D65u, dat::blockWord(task.block), i});
        if (request.anySize)
            setAnySize(views[i], {request.seed, {0x73697A65u, dat::blockWord(task.block), i}});
        views[i].seconds = std::floor(random.between(0.0, request.longest) * 100.0) / 100.0;
        views[i].doors = request.doors;
        views[i].dayGroup = request.dayGroup;
        views[i].rain = request.rain;
        views[i].look = request.look;
    }
    views.insert(views.end(), task.given.begin(), task.given.end());
    return views;
}

Result<void> runCheck(const RunRequest& request, Drawer& drawer, const RunEvents& events,
                      Progress& progress) {
    const double before = progress.totals.seconds;
    const Clock::time_point start = Clock::now();
    Result<void> done = Runner(request, drawer, events, progress).run();
    progress.totals.seconds = before + std::chrono::duration<double>(Clock::now() - start).count();
    return done;
}

} // namespace limen::check
