#include "check/Judging.h"

#include <chrono>

namespace limen::check {

namespace {

/// Pixels of waiting views: about a hundred small views, or 18 of 640×360; 100 MiB. Hundreds of views around
/// one opening may trace slower than they draw, and the next hundreds faster.
constexpr std::size_t kMostWaiting = std::size_t{1} << 22;

std::size_t pixelsOf(const DrawnView& view) {
    return std::size_t{view.images.width} * view.images.height;
}

reference::Camera throughSample(reference::Camera camera, glm::vec2 sample) {
    camera.place = Vec2(sample);
    return camera;
}

} // namespace

Judging::Judging(TracedWorld& traced, std::size_t first, unsigned threads, IdColour idColour,
                 const RunEvents& events, Progress& progress)
    : traced_(traced), threads_(threads), idColour_(idColour), events_(events), progress_(progress),
      next_(first), thread_([this] { work(); }) {}

Judging::~Judging() {
    {
        const std::lock_guard guard(lock_);
        ending_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void Judging::add(std::size_t index, DrawnView view) {
    {
        std::unique_lock guard(lock_);
        // The view that is judged next never blocks: all others wait for it.
        changed_.wait(guard, [&] { return waitingPixels_ < kMostWaiting || index == next_ || gaveUp_; });
        waitingPixels_ += pixelsOf(view);
        waiting_.emplace(index, std::move(view));
    }
    changed_.notify_all();
}

void Judging::giveUp() {
    {
        const std::lock_guard guard(lock_);
        gaveUp_ = true;
    }
    changed_.notify_all();
}

Result<void> Judging::finish() {
    std::unique_lock guard(lock_);
    changed_.wait(guard, [this] { return !isNextThere() && !busy_; });
    return failure_;
}

Progress Judging::progress() const {
    const std::lock_guard guard(lock_);
    return progress_;
}

void Judging::work() {
    for (;;) {
        DrawnView next;
        {
            std::unique_lock guard(lock_);
            changed_.wait(guard, [this] { return isNextThere() || ending_; });
            if (!isNextThere())
                return;
            next = std::move(waiting_.begin()->second);
            waiting_.erase(waiting_.begin());
            waitingPixels_ -= pixelsOf(next);
            ++next_;
            busy_ = true;
        }
        changed_.notify_all();
        judge(next);
        {
            const std::lock_guard guard(lock_);
            busy_ = false;
        }
        changed_.notify_all();
    }
}

void Judging::judge(const DrawnView& drawn) {
    const auto start = std::chrono::steady_clock::now();
    traced_.setDynamics(drawn.dynamics);
    reference::tracePicture(traced_.scene(), drawn.camera, threads_, picture_);
    ViewRetracer retracer(traced_, drawn.camera);
    if (drawn.images.samples.empty())
        compare(drawn.images, picture_, retracer, comparison_);
    else
        judgeSamples(drawn, retracer);
    const std::uint64_t hash = hashOf(drawn.images);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::uint64_t number = 0;
    {
        const std::lock_guard guard(lock_);
        number = progress_.totals.sum().views;
        progress_.totals.add(drawn.view, number, comparison_, drawn.moved, hash);
        progress_.totals.drawSeconds += drawn.seconds;
        progress_.totals.traceSeconds += seconds;
        ++progress_.views;
    }
    const auto& shows = comparison_.findings() == 0 && drawn.moved == 0 ? events_.right : events_.picture;
    if (!shows)
        return;
    Result<void> shown = shows({drawn.view, number, drawn.images, picture_, comparison_});
    const std::lock_guard guard(lock_);
    if (!shown && failure_)
        failure_ = std::move(shown);
}

void Judging::judgeSamples(const DrawnView& drawn, Retracer& retracer) {
    const std::vector<glm::vec2>& samples = drawn.images.samples;
    sampled_.resize(samples.size());
    for (std::size_t s = 0; s < samples.size(); ++s)
        reference::tracePicture(traced_.scene(), throughSample(drawn.camera, samples[s]), threads_,
                                sampled_[s]);
    compareSampled(drawn.images, sampled_, idColour_, retracer, comparison_);
}

} // namespace limen::check
