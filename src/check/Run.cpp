#include "check/Run.h"

#include "check/Dice.h"
#include "check/Judging.h"
#include "check/Views.h"
#include "core/Assert.h"
#include "world/Loader.h"

#include <chrono>
#include <numeric>

namespace limen::check {

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kBetweenSaves = std::chrono::seconds(5);

std::size_t askedOf(const RunRequest& request, const BlockTask& task) {
    return task.total() + tourPointsIn(request.tour, task.tourViews, task.block);
}

world::SpaceIndex rootOf(const world::World& world, const View& view) {
    return view.root == 0 ? world::kOutside : world::findCell(world, view.root);
}

/// One run on its way.
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
    /// A block of the run. Its last views are judged while the next block is made ready.
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
        if (!loaded) { // one damaged block among thousands must not end the run; the report counts it
            ++progress_.totals.blocksLeftOut;
            if (events_.leftOut)
                events_.leftOut(task.block, loaded.error());
            endTask();
            return {};
        }
        block_ = std::move(next);
        return drawViews(views);
    }

    Result<void> drawViews(const std::vector<View>& views) {
        const std::size_t first = progress_.views;
        Judging& judging =
            block_->judging.emplace(block_->traced, request_.threads, drawer_.idColour(), events_, progress_);
        for (std::size_t v = first; v < views.size(); ++v) {
            Result<DrawnView> drawn = draw(*block_->world, views[v]);
            if (!drawn)
                return tl::unexpected(drawn.error());
            judging.add(std::move(*drawn));
            step(v + 1);
            if (Clock::now() - saved_ > kBetweenSaves) {
                if (Result<void> kept = save(judging.progress()); !kept)
                    return kept;
            }
        }
        return {};
    }

    /// Waits until the block's views are judged, and lets go of it.
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

    Result<DrawnView> draw(const world::World& world, const View& view) {
        DrawnView drawn;
        drawn.view = view;
        const world::SpaceIndex root = rootOf(world, view);
        LIMEN_ASSERT(root != world::kNone, "views have roots that are loaded");
        drawn.camera = drawer_.cameraOf(view, root);
        const bool still = view.kind == Kind::Still;
        const Clock::time_point start = Clock::now();
        Result<DrawnImages> images = drawer_.draw(view, root, still);
        if (!images)
            return tl::unexpected(images.error());
        drawn.images = std::move(*images);
        drawn.moment = drawer_.moment();
        if (still) {
            const Result<DrawnImages> again = drawer_.draw(view, root, true);
            if (!again)
                return tl::unexpected(again.error());
            drawn.moved = pixelsThatMoved(drawn.images, *again);
        }
        drawn.seconds = std::chrono::duration<double>(Clock::now() - start).count();
        return drawn;
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
    std::size_t asked_ = 0;        ///< by the tasks that are done
    std::unique_ptr<Block> block_; ///< whose views are drawn or judged
};

} // namespace

std::size_t viewsAsked(const RunRequest& request) {
    return std::accumulate(
        request.tasks.begin(), request.tasks.end(), std::size_t{0},
        [&](std::size_t sum, const BlockTask& task) { return sum + askedOf(request, task); });
}

std::vector<View> viewsOf(const RunRequest& request, const BlockTask& task, const world::World& world,
                          const reference::Scene& scene) {
    Surroundings around{world, scene, task.block, request.seed, request.width, request.height, request.tour};
    const auto count = [&](Kind kind) { return task.counts[static_cast<std::size_t>(kind)]; };
    std::vector<View> views;
    addRandomViews(around, Kind::Random, count(Kind::Random), views);
    addOutsideViews(around, count(Kind::Outside), views);
    if (task.tourViews > 0)
        addTourViews(around, task.tourViews, views);
    addWalkViews(around, count(Kind::Path), views);
    addRandomViews(around, Kind::Still, count(Kind::Still), views);
    around.width = request.sweepWidth;
    around.height = request.sweepHeight;
    addSweepViews(around, count(Kind::Sweep), views);
    for (std::size_t i = 0; i < views.size(); ++i) {
        Dice dice(request.seed, {0x74696D65u, dat::blockWord(task.block), i});
        views[i].seconds = std::floor(dice.between(0.0, request.longest) * 100.0) / 100.0;
        views[i].doors = request.doors;
        views[i].rain = request.rain;
    }
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
