#pragma once

#include "check/Drawing.h"

#include <thread>

namespace limen::check {

/// A second drawer on its own thread. One drawer of small pictures keeps a core busy for a part of the time
/// only; two fill two cores.
class DrawingHelper {
public:
    /// Without a helper, or if making it fails, this object draws nothing and the drawer draws every view.
    explicit DrawingHelper(Drawer& drawer);
    ~DrawingHelper();
    DrawingHelper(const DrawingHelper&) = delete;
    DrawingHelper& operator=(const DrawingHelper&) = delete;

    /// Starts drawing from the queue, after taking over the drawer's world around `block`. All arguments must
    /// live until finish().
    void start(dat::BlockCoord block, ViewQueue& queue, Judging& judging);
    /// Waits for the end of drawing. Errors: the helper's.
    [[nodiscard]] Result<void> finish();

private:
    struct Job {
        dat::BlockCoord block;
        ViewQueue& queue;
        Judging& judging;
    };
    void work();

    Drawer& drawer_;
    std::mutex lock_;
    std::condition_variable changed_;
    std::optional<Job> job_; // under lock_; reset when done
    bool ending_ = false;    // under lock_
    Result<void> failure_;   // under lock_
    std::thread thread_;     // last: the thread uses the members above
};

} // namespace limen::check
