#include "check/DrawingHelper.h"

namespace limen::check {

DrawingHelper::DrawingHelper(Drawer& drawer) : drawer_(drawer), thread_([this] { work(); }) {}

DrawingHelper::~DrawingHelper() {
    {
        const std::lock_guard guard(lock_);
        ending_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void DrawingHelper::start(dat::BlockCoord block, ViewQueue& queue, Judging& judging) {
    {
        const std::lock_guard guard(lock_);
        job_.emplace(Job{block, queue, judging});
    }
    changed_.notify_all();
}

Result<void> DrawingHelper::finish() {
    std::unique_lock guard(lock_);
    changed_.wait(guard, [this] { return !job_; });
    return std::exchange(failure_, {});
}

void DrawingHelper::work() {
    const Result<std::unique_ptr<Drawer>> made = drawer_.makeHelper();
    Drawer* const own = made ? made->get() : nullptr;
    for (;;) {
        {
            std::unique_lock guard(lock_);
            changed_.wait(guard, [this] { return job_ || ending_; });
            if (!job_)
                return;
        }
        Result<void> drawn;
        if (own != nullptr && own->load(job_->block))
            drawn = drawAll(job_->queue, *own, job_->judging);
        {
            const std::lock_guard guard(lock_);
            failure_ = std::move(drawn);
            job_.reset();
        }
        changed_.notify_all();
    }
}

} // namespace limen::check
