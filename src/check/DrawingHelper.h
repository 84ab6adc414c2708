#pragma once

#include "check/Drawing.h"

#include <thread>

namespace limen::check {

/// A second drawer on a thread of its own. Drawing a small picture keeps one core busy for a part of the time only: two at once
/// fill two cores.
class DrawingHelper {
public:
    /// Nothing is drawn if the drawer has no helper to offer, or that fails: then the drawer does all of it.
    explicit DrawingHelper(Drawer& drawer);
    ~DrawingHelper();
    DrawingHelper(const DrawingHelper&) = delete;
    DrawingHelper& operator=(const DrawingHelper&) = delete;

    /// Lets it draw from the queue, once it has taken over what the drawer has loaded from `block`. All of these must live until
    /// finish().
    void start(dat::BlockCoord block, ViewQueue& queue, Judging& judging);
    /// Waits until it draws no more. Errors: what drawing met.
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
    std::optional<Job> job_; // under lock_; until it is done
    bool ending_ = false;    // under lock_
    Result<void> failure_;   // under lock_
    std::thread thread_;     // last: starts when the rest is there
};

} // namespace limen::check
